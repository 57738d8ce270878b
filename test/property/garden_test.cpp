// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every public algorithm on every surface of the garden: it succeeds, or reports what is wrong.

#include "property/garden_surfaces.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace garden;
using Defect = IT::Invalid_surface_error::Defect;

// The symbol of an exception in a cell of the table.
const std::map<Defect, std::string>& defect_codes()
{
  static const std::map<Defect, std::string> codes{{Defect::EMPTY, "EMPTY"},
                                                   {Defect::NON_MANIFOLD_EDGE, "EDGE"},
                                                   {Defect::INCONSISTENT_ORIENTATION, "ORIENT"},
                                                   {Defect::NON_MANIFOLD_VERTEX, "VERTEX"},
                                                   {Defect::NOT_FINITE, "FINITE"},
                                                   {Defect::OUT_OF_RANGE, "RANGE"},
                                                   {Defect::ZERO_LENGTH_EDGE, "ZERO"},
                                                   {Defect::TRIANGLE_INEQUALITY, "INEQU"},
                                                   {Defect::DEGENERATE_FACE, "DEGEN"},
                                                   {Defect::WRONG_TOPOLOGY, "TOPO"}};
  return codes;
}

std::string outcome(const Algorithm& algorithm, const Surface& surface)
{
  try {
    algorithm.run(surface);
    return "ok";
  } catch (const Not_applicable&) {
    return "-";
  } catch (const IT::Error& error) {
    EXPECT_GT(std::string(error.what()).size(), 10u) << "no message";
    if (dynamic_cast<const IT::Undecided_error*>(&error))
      return "UNDECID";
    if (dynamic_cast<const IT::Numerical_error*>(&error))
      return "NUMERIC";
    if (const auto* e = dynamic_cast<const IT::Invalid_surface_error*>(&error)) {
      const auto code = defect_codes().find(e->defect());
      return code == defect_codes().end() ? "OTHER" : code->second;
    }
    return "ERROR";
  }
}

std::vector<Algorithm> algorithms()
{
  std::vector<Algorithm> result = cover_algorithms();
  for (const std::vector<Algorithm>& more : {metric_algorithms(), operator_algorithms()})
    result.insert(result.end(), more.begin(), more.end());
  return result;
}

// Columns, from the left: the operator of a tufted cover; examine, double, half angles, filtered; verify, overlay,
// positions, transfer, locate, mesh, gluing file, mollify; stiffness, mass, condition, project; maps to the circle, to
// the triangle, with natural boundary, conformally. Rows are surfaces. `-` is for what takes points and gets
// lengths, and `=` for all cells further to the right as the one before.
const char* const expected_table = R"(
one triangle               | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
hinge with a flip          | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
square, a tie              | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
tetrahedron                | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
two triangles, a sphere    | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
pillow                     | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
one-vertex torus           | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   ok
sheared torus              | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   ok
triangle glued to itself   | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     ok     ok     ok     ERROR  NUMERIC ok
sphere of two cones        | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
random gluing              | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
random open gluing         | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
Moebius strip              | ok     ORIENT =
50 tetrahedra              | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
20 triangles, all border   | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   ok
vertex of degree 1000      | ok     =
needle                     | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
needle hinge               | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
cap                        | ok     =
cap without area           | ok     =
three points on a line     | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     DEGEN  ok     DEGEN  ok     DEGEN  DEGEN  DEGEN  ZERO
edge of length zero        | ok     ZERO   =
coordinates of 1e150       | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
coordinates of 1e-150      | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
disk of 1e150              | ok     =
disk of 1e-150             | ok     =
coordinates of 1e300       | RANGE  ok     RANGE  RANGE  RANGE  ok     ok     RANGE  ok     ok     RANGE  ok     ok     ok     RANGE  ok     RANGE  TOPO   TOPO   RANGE  ok
1e150 beside 1e-150        | RANGE  =
lengths of 1e150           | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   ok
lengths of 1e-150          | ok     -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   ok
lengths 1, 1, 3            | INEQU  -      INEQU  INEQU  INEQU  INEQU  INEQU  INEQU  INEQU  INEQU  -      INEQU  =
lengths 1, 1, 2            | ZERO   -      ok     ok     ok     ok     ok     ok     ok     ok     -      ok     ok     DEGEN  ok     DEGEN  ok     DEGEN  DEGEN  DEGEN  ZERO
infinite coordinate        | FINITE =
NaN for a length           | FINITE -      FINITE FINITE FINITE FINITE FINITE FINITE FINITE FINITE -      FINITE =
vertex without a face      | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
no face                    | EMPTY  EMPTY  ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     TOPO   TOPO   TOPO   EMPTY
edge with three faces      | ok     EDGE   =
two fans at a vertex       | ok     VERTEX =
bumpy sphere               | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
bumpy dome                 | ok     =
disk with spike            | ok     =
bad torus                  | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
helical tube               | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
prism                      | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
Schwarz lantern            | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
sliver sheet               | ok     =
strip                      | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   ok     =
random diagonal grid       | ok     =
sheared grid               | ok     =
latitude-longitude sphere  | ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     ok     TOPO   TOPO   TOPO   ok
)";

std::map<std::string, std::vector<std::string>> expected_outcomes(std::size_t number_of_columns)
{
  std::map<std::string, std::vector<std::string>> rows;
  std::istringstream table(expected_table);
  std::string line;
  while (std::getline(table, line)) {
    const std::size_t bar = line.find('|');
    if (bar == std::string::npos)
      continue;
    const std::string name = line.substr(0, line.find_last_not_of(' ', bar - 1) + 1);
    std::istringstream cells(line.substr(bar + 1));
    std::vector<std::string>& row = rows[name];
    for (std::string cell; cells >> cell;)
      row.push_back(cell);
    while (!row.empty() && row.back() == "=")
      row.pop_back();
    if (!row.empty())
      row.resize((std::max)(row.size(), number_of_columns), row.back());
  }
  return rows;
}

// Work around a vertex takes linear time, or this would not end. With CGAL's checks and sanitizers a million still
// takes too long.
#ifdef CGAL_DEBUG
constexpr std::uint32_t high_degree = 2000, highest_degree = 20000;
#else
constexpr std::uint32_t high_degree = 20000, highest_degree = 1000000;
#endif

TEST(Garden, EveryAlgorithmAtAVertexOfHighDegree)
{
  const Surface surface = fan(high_degree);
  for (const Algorithm& algorithm : algorithms()) {
    SCOPED_TRACE(algorithm.name);
    EXPECT_EQ(outcome(algorithm, surface), "ok");
  }
}

TEST(Garden, AVertexOfAMillionEdges)
{
  const Surface surface = fan(highest_degree);
  for (const Algorithm& algorithm : algorithms())
    for (const char* name : {"examine", "filtered", "overlay", "mesh", "mass"})
      if (algorithm.name == name) {
        SCOPED_TRACE(name);
        EXPECT_EQ(outcome(algorithm, surface), "ok");
      }
}

TEST(Garden, EveryAlgorithmOnEverySurfaceDoesItsJobOrSaysWhatIsWrong)
{
  const std::vector<Algorithm> columns = algorithms();
  const auto expected = expected_outcomes(columns.size());
  std::ostringstream table;
  std::size_t cells = 0;
  for (const Named_surface& named : garden_surfaces()) {
    SCOPED_TRACE(named.name);
    const auto row = expected.find(named.name);
    EXPECT_NE(row, expected.end()) << "there is no such row";
    table << std::left << std::setw(27) << named.name << "|";
    for (std::size_t i = 0; i < columns.size(); ++i) {
      SCOPED_TRACE(columns[i].name);
      const std::string found = outcome(columns[i], named.surface);
      table << " " << std::setw(7) << found;
      if (row != expected.end()) {
        EXPECT_EQ(found, row->second.at(i));
      }
      ++cells;
    }
    table << "\n";
  }
  EXPECT_EQ(cells, columns.size() * expected.size());
  if (HasFailure())
    std::cout << table.str();
}

} // namespace
