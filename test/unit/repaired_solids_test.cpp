// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids that touch themselves along edges: closed surfaces stay closed, and each piece bounds a part of the solid.

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;
using Cell = std::array<int, 3>;

struct Mesh
{
  Points points;
  Triangles faces;
};

enum class Walls {
  NONE,
  TWICE,     // each cell has all its faces
  CUT_ANYHOW // likewise, and squares are cut along any diagonal
};

// The boundary of a union of cells, with a vertex for each corner; faces point outward. A cell has 12 faces in a row if
// there are walls.
Mesh boundary(const std::set<Cell>& cells, Walls walls = Walls::NONE, std::mt19937* random = nullptr)
{
  Mesh mesh;
  std::map<Cell, std::size_t> number;
  const auto vertex = [&](const Cell& p) {
    const auto [it, is_new] = number.emplace(p, mesh.points.size());
    if (is_new)
      mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell neighbor = cell, corner = cell;
        neighbor[axis] += 2 * side - 1;
        if (cells.count(neighbor) != 0 && walls == Walls::NONE)
          continue;
        corner[axis] += side;
        std::array<std::size_t, 4> square;
        for (std::size_t i = 0; i < 4; ++i) {
          Cell p = corner;
          p[(axis + 1) % 3] += i == 1 || i == 2;
          p[(axis + 2) % 3] += i >= 2;
          square[i] = vertex(p);
        }
        if (side == 0)
          std::swap(square[1], square[3]);
        if (walls == Walls::CUT_ANYHOW && (*random)() % 2 == 0)
          std::rotate(square.begin(), square.begin() + 1, square.end());
        mesh.faces.push_back({square[0], square[1], square[2]});
        mesh.faces.push_back({square[0], square[2], square[3]});
      }
  return mesh;
}

std::size_t number_of_solids(std::set<Cell> cells) // that faces join
{
  std::size_t count = 0;
  for (; !cells.empty(); ++count) {
    std::vector<Cell> stack{*cells.begin()};
    cells.erase(cells.begin());
    while (!stack.empty()) {
      const Cell cell = stack.back();
      stack.pop_back();
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          Cell neighbor = cell;
          neighbor[axis] += step;
          if (cells.erase(neighbor) != 0)
            stack.push_back(neighbor);
        }
    }
  }
  return count;
}

void turn_over(std::array<std::size_t, 3>& face) { std::swap(face[0], face[2]); }

Mesh turned_over(Mesh mesh)
{
  for (auto& face : mesh.faces)
    turn_over(face);
  return mesh;
}

// Six times the volume of each component; exact for small integers.
std::vector<double> volumes(const IT::Repaired_polygons& repaired)
{
  std::vector<std::size_t> root(repaired.points.size());
  for (std::size_t v = 0; v < root.size(); ++v)
    root[v] = v;
  const auto find = [&root](std::size_t v) {
    while (root[v] != v)
      v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& [a, b, c] : repaired.triangles) {
    root[find(a)] = find(b);
    root[find(b)] = find(c);
  }
  std::map<std::size_t, double> volume;
  for (const auto& [a, b, c] : repaired.triangles) {
    const auto &p = repaired.points[a], &q = repaired.points[b], &r = repaired.points[c];
    volume[find(a)] +=
      p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  std::vector<double> result;
  for (const auto& [v, x] : volume)
    result.push_back(x);
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t count(const IT::Repaired_polygons& repaired, IT::Repair_kind kind)
{
  for (const IT::Repair& repair : repaired.repairs)
    if (repair.kind == kind)
      return repair.count;
  return 0;
}

// Repairs, and expects a surface of the same faces with this many border edges, and this many of them made by the
// repair.
IT::Repaired_polygons expect_surface(const Mesh& mesh, std::size_t border_edges = 0, std::size_t opened_edges = 0)
{
  IT::Repaired_polygons repaired = IT::repair_polygons(mesh.points, mesh.faces);
  const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
  EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
  EXPECT_EQ(report.number_of_border_edges, border_edges);
  EXPECT_EQ(count(repaired, IT::Repair_kind::OPENED_EDGE), opened_edges);
  EXPECT_EQ(repaired.triangles.size(), mesh.faces.size());
  for (std::size_t f = 0; f < repaired.triangles.size(); ++f) {
    std::array<std::size_t, 3> before = mesh.faces[f], after = repaired.triangles[f];
    EXPECT_EQ(repaired.input_faces[f], f);
    for (std::size_t& v : after)
      v = repaired.input_vertices[v];
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after) << f;
  }
  return repaired;
}

double sum(const std::vector<double>& numbers)
{
  double result = 0;
  for (const double x : numbers)
    result += x;
  return result;
}

// A solid of cells comes apart into parts joined by faces, and none of its faces is turned.
void expect_solids(const std::set<Cell>& cells)
{
  const Mesh mesh = boundary(cells);
  const IT::Repaired_polygons repaired = expect_surface(mesh);
  const std::vector<double> pieces = volumes(repaired);
  EXPECT_EQ(sum(pieces), 6. * double(cells.size()));
  EXPECT_EQ(std::size_t(std::count_if(pieces.begin(), pieces.end(), [](double x) { return x > 0; })),
            number_of_solids(cells));
  EXPECT_EQ(count(repaired, IT::Repair_kind::REVERSED_FACE), 0u);

  const IT::Repaired_polygons inside_out = expect_surface(turned_over(mesh));
  EXPECT_EQ(inside_out.points.size(), repaired.points.size());
  std::vector<double> negative = volumes(inside_out);
  std::reverse(negative.begin(), negative.end());
  for (double& x : negative)
    x = -x;
  EXPECT_EQ(negative, pieces);
}

std::set<Cell> random_cells(std::mt19937& random, int n, double density)
{
  std::set<Cell> cells;
  std::bernoulli_distribution is_full(density);
  for (int i = 0; i < n * n * n; ++i)
    if (is_full(random))
      cells.insert({i % n, i / n % n, i / n / n});
  return cells;
}

const std::set<Cell> six_cells{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(Repaired_solids, six_cells_around_an_empty_one_stay_closed)
{
  const Mesh mesh = boundary(six_cells);
  ASSERT_EQ(mesh.points.size(), 32u);
  ASSERT_EQ(mesh.faces.size(), 72u);
  expect_solids(six_cells);
  EXPECT_EQ(volumes(IT::repair_polygons(mesh.points, mesh.faces)), std::vector<double>(6, 6.));
}

TEST(Repaired_solids, cells_that_share_edges_come_apart)
{
  expect_solids({{0, 0, 0}, {1, 1, 0}});                       // two at an edge
  expect_solids({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}); // four, each two of which share one
  expect_solids({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}});
  std::set<Cell> checkerboard, shell;
  for (int i = 0; i < 64; ++i)
    if (const Cell cell{i % 4, i / 4 % 4, i / 16}; (cell[0] + cell[1] + cell[2]) % 2 == 0)
      checkerboard.insert(cell);
  expect_solids(checkerboard);
  // A hollow cube whose walls touch at an edge between the hollow and the outside: its walls stay one piece.
  for (int i = 0; i < 27; ++i)
    if (i != 13 && i != 9 + 3 + 0 && i != 9 + 1)
      shell.insert({i % 3, i / 3 % 3, i / 9});
  expect_solids(shell);
}

TEST(Repaired_solids, random_cells)
{
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const std::set<Cell> cells = random_cells(random, 2 + round % 4, 0.2 + 0.1 * (round % 7));
    if (!cells.empty())
      expect_solids(cells);
  }
}

TEST(Repaired_solids, faces_turned_at_random)
{
  std::mt19937 random(8);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const std::set<Cell> cells = random_cells(random, 2 + round % 3, 0.2 + 0.1 * (round % 7));
    if (cells.empty())
      continue;
    Mesh mesh = boundary(cells);
    for (auto& face : mesh.faces)
      if (random() % 2 == 0)
        turn_over(face);
    expect_surface(mesh);
  }
  // One square of the six cells, which is a piece of its own if it looks to the empty cell.
  for (std::size_t f = 0; f < 72; f += 2) {
    Mesh mesh = boundary(six_cells);
    turn_over(mesh.faces[f]);
    turn_over(mesh.faces[f + 1]);
    const std::vector<double> pieces = volumes(expect_surface(mesh));
    EXPECT_EQ(pieces, std::vector<double>(6, f == 0 ? -6. : 6.)); // the first face is not turned
  }
}

TEST(Repaired_solids, in_any_place_and_of_any_size)
{
  for (const double scale : {1e-300, 1e-160, 0.1, 1e160, 1e305}) {
    SCOPED_TRACE(scale);
    Mesh mesh = boundary(six_cells);
    for (auto& p : mesh.points)
      p = {(3 * p[0] - p[1] + 0.3) * scale, (p[1] / 3 + p[2] / 7) * scale, (p[0] - 5 * p[2]) * scale};
    const IT::Repaired_polygons repaired = IT::repair_polygons(mesh.points, mesh.faces);
    const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
    EXPECT_EQ(report.number_of_border_edges, 0u);
    EXPECT_EQ(report.number_of_components, 6u);
  }
}

// Appends another mesh; vertices at the same place become one.
void append(Mesh& mesh, const Mesh& other)
{
  std::vector<std::size_t> number;
  for (const auto& p : other.points) {
    number.push_back(std::size_t(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin()));
    if (number.back() == mesh.points.size())
      mesh.points.push_back(p);
  }
  for (const auto& [a, b, c] : other.faces)
    mesh.faces.push_back({number[a], number[b], number[c]});
}

Mesh scaled(Mesh mesh, double factor)
{
  for (auto& p : mesh.points)
    for (double& x : p)
      x *= factor;
  return mesh;
}

TEST(Repaired_solids, solids_within_each_other_are_not_turned)
{
  // A prism within another, along one of its edges; the inner one is solid, or hollow.
  const auto prism = [](double size) {
    return Mesh{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, 1}, {size, 0, 1}, {0, size, 1}},
                {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  };
  Mesh inner{{{0, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 0, 1}, {2, 1, 1}, {1, 2, 1}}, prism(1).faces};
  for (const bool is_hollow : {false, true})
    for (const bool is_inside_out : {false, true}) {
      Mesh mesh = prism(9);
      append(mesh, is_hollow ? turned_over(inner) : inner);
      const IT::Repaired_polygons repaired = expect_surface(is_inside_out ? turned_over(mesh) : mesh);
      EXPECT_EQ(count(repaired, IT::Repair_kind::REVERSED_FACE), 0u);
      EXPECT_EQ(std::abs(sum(volumes(repaired))), 3 * 81. + (is_hollow ? -3 : 3) * 3.);
      EXPECT_EQ(volumes(repaired).size(), 2u);
    }
}

TEST(Repaired_solids, solids_that_overlap_stay_whole)
{
  // Two wedges along one edge, of which one begins within the other and ends outside.
  const auto wedge = [](double x, double y, double z, double w) {
    return Mesh{{{0, 0, 0}, {x, y, 0}, {z, w, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  };
  Mesh mesh = wedge(4, 0, 0, 4);
  append(mesh, wedge(5, 5, -5, 5));
  EXPECT_EQ(volumes(expect_surface(mesh)), (std::vector<double>{16, 50}));
}

TEST(Repaired_solids, faces_that_lie_on_each_other)
{
  // A box on a larger one, flush with an edge: two faces at that edge are in one half-plane.
  Mesh mesh = scaled(boundary({{0, 0, 0}}), 2);
  Mesh top = boundary({{0, 0, 0}});
  for (auto& p : top.points)
    p = {2 * p[0], p[1], p[2] + 2};
  append(mesh, top);
  EXPECT_EQ(sum(volumes(expect_surface(mesh))), 6 * (8 + 2.));
  EXPECT_EQ(sum(volumes(expect_surface(turned_over(mesh)))), -6 * (8 + 2.));
}

// The sets of at most n of the cells.
std::vector<std::set<Cell>> sets_of_cells(const std::vector<Cell>& all, std::size_t n)
{
  std::vector<std::set<Cell>> result;
  for (std::size_t bits = 1; bits < std::size_t(1) << all.size(); ++bits) {
    std::set<Cell> cells;
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((bits >> i & 1) != 0)
        cells.insert(all[i]);
    if (cells.size() <= n)
      result.push_back(cells);
  }
  return result;
}
std::vector<Cell> block(int a, int b, int c)
{
  std::vector<Cell> result;
  for (int i = 0; i < a * b * c; ++i)
    result.push_back({i % a, i / a % b, i / a / b});
  return result;
}
std::vector<std::set<Cell>> few_cells()
{
  std::vector<std::set<Cell>> result = sets_of_cells(block(2, 2, 2), 4);
  for (const auto& all : {block(2, 2, 2), block(3, 3, 3)})
    result.push_back({all.begin(), all.end()});
  for (const auto& cells : {sets_of_cells(block(3, 3, 1), 3), sets_of_cells(block(4, 1, 1), 4)})
    result.insert(result.end(), cells.begin(), cells.end());
  return result;
}

// Each cell is closed by itself, and so is the result; only so many faces are gone.
template <class Faces>
void expect_rooms(const Points& points, const Faces& faces, std::size_t number_of_cells, std::size_t surplus = 0)
{
  const IT::Repaired_polygons repaired = IT::repair_polygons(points, faces);
  const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
  EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
  EXPECT_EQ(report.number_of_border_edges, 0u);
  EXPECT_EQ(count(repaired, IT::Repair_kind::DUPLICATE_FACE), surplus);
  EXPECT_EQ(count(repaired, IT::Repair_kind::DUPLICATE_PART), 0u);
  EXPECT_EQ(repaired.triangles.size(), 12 * number_of_cells);
  std::vector<double> pieces = volumes(repaired);
  for (double& x : pieces)
    x = std::abs(x);
  EXPECT_EQ(pieces, std::vector<double>(number_of_cells, 6.));
}

TEST(Repaired_solids, rooms_that_share_walls_stay_closed)
{
  std::mt19937 random(10);
  for (const std::set<Cell>& cells : few_cells())
    for (const Walls walls : {Walls::TWICE, Walls::CUT_ANYHOW})
      for (const int turned : {0, 1, 2, 3}) { // none, all, cells, faces
        SCOPED_TRACE(testing::PrintToString(cells) + " turned " + std::to_string(turned) +
                     (walls == Walls::CUT_ANYHOW ? " cut anyhow" : ""));
        if (walls == Walls::CUT_ANYHOW && turned > 1)
          continue; // triangles that overlap tell nothing of their directions
        Mesh mesh = boundary(cells, walls, &random);
        bool is_turned = turned == 1;
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
          if (turned == 3 || (turned == 2 && f % 12 == 0))
            is_turned = random() % 2 == 0;
          if (is_turned)
            turn_over(mesh.faces[f]);
        }
        expect_rooms(mesh.points, mesh.faces, cells.size());
      }
}

// Two rooms that share a wall, and two cells that touch them along an edge.
TEST(Repaired_solids, rooms_and_cells_that_touch_them_may_differ_in_direction)
{
  for (const std::set<Cell>& cells : {std::set<Cell>{{0, 0, 0}, {0, 0, 2}, {0, 1, 1}, {0, 2, 1}},
                                      {{0, 0, 0}, {0, 1, 1}, {0, 1, 2}, {1, 1, 3}},
                                      {{0, 0, 0}, {0, 1, 1}, {1, 0, 2}, {1, 1, 1}}})
    for (std::size_t are_turned = 0; are_turned < 16; ++are_turned) {
      SCOPED_TRACE(testing::PrintToString(cells) + " turned " + std::to_string(are_turned));
      Mesh mesh = boundary(cells, Walls::TWICE);
      for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if ((are_turned >> f / 12 & 1) != 0)
          turn_over(mesh.faces[f]);
      expect_rooms(mesh.points, mesh.faces, cells.size());
    }
}

TEST(Repaired_solids, what_is_really_doubled_goes)
{
  std::mt19937 random(11);
  for (const std::set<Cell>& cells : few_cells())
    for (const bool are_all_doubled : {false, true}) {
      SCOPED_TRACE(testing::PrintToString(cells) + (are_all_doubled ? " all" : " some"));
      const Mesh mesh = boundary(cells, Walls::TWICE);
      Triangles faces = mesh.faces;
      std::set<std::size_t> chosen;
      for (int i = 0; i < 3; ++i)
        chosen.insert(random() % faces.size());
      for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (are_all_doubled || chosen.count(f) != 0) {
          faces.push_back(mesh.faces[f]);
          if (random() % 2 == 0)
            turn_over(faces.back());
        }
      expect_rooms(mesh.points, faces, cells.size(), faces.size() - mesh.faces.size());
    }
}

TEST(Repaired_solids, rooms_of_squares)
{
  // A square of the wall begins at another corner than the one that lies on it.
  const Points points = boundary({{0, 0, 0}, {1, 0, 0}}).points;
  const auto at = [&](double x, double y, double z) {
    return std::size_t(std::find(points.begin(), points.end(), std::array<double, 3>{x, y, z}) - points.begin());
  };
  std::vector<std::vector<std::size_t>> faces;
  for (const double x : {0., 1.}) {
    const std::size_t a = at(x, 0, 0), b = at(x + 1, 0, 0), c = at(x + 1, 1, 0), d = at(x, 1, 0), e = at(x, 0, 1),
                      f = at(x + 1, 0, 1), g = at(x + 1, 1, 1), h = at(x, 1, 1);
    for (const auto& face : std::vector<std::vector<std::size_t>>{
           {a, d, c, b}, {e, f, g, h}, {a, b, f, e}, {b, c, g, f}, {c, d, h, g}, {a, e, h, d}})
      faces.push_back(face);
  }
  expect_rooms(points, faces, 2);
  faces.push_back({at(0, 1, 1), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1)});
  expect_rooms(points, faces, 2, 1);
}

TEST(Repaired_solids, a_room_without_a_roof_keeps_its_wall)
{
  for (const std::size_t roof : {10, 22}) { // of the first cell, of the second
    Mesh mesh = boundary({{0, 0, 0}, {1, 0, 0}}, Walls::TWICE);
    mesh.faces.erase(mesh.faces.begin() + std::ptrdiff_t(roof), mesh.faces.begin() + std::ptrdiff_t(roof) + 2);
    expect_surface(mesh, 4, 1); // its edge at the wall had two faces of others
  }
}

TEST(Repaired_solids, a_fin_of_two_sides_leaves_no_border)
{
  for (const double x : {-1., 0.25}) { // outside, inside
    Mesh mesh = boundary({{0, 0, 0}});
    append(mesh, {{{0, 0, 0}, {0, 0, 1}, {x, x, 0.5}}, {{0, 1, 2}, {1, 0, 2}}});
    const IT::Repaired_polygons repaired = IT::repair_polygons(mesh.points, mesh.faces);
    const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
    EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
    EXPECT_EQ(report.number_of_border_edges, 0u);
    EXPECT_EQ(volumes(repaired), std::vector<double>{6});
    ASSERT_FALSE(repaired.repairs.empty());
    EXPECT_EQ(IT::message(repaired.repairs[0]),
              "face 12 was removed with face 13, as they have the same corners and enclose nothing, and 1 more face "
              "like it");
    // With a vertex inside, both sides of the fin can stay.
    Mesh large = boundary({{0, 0, 0}});
    const Points corners{{0, 0, 0}, {0, 0, 1}, {x, x, 0.5}, {x / 2, x / 2, 0.5}};
    append(large, {corners, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}});
    EXPECT_EQ(volumes(expect_surface(large)), (std::vector<double>{0, 6}));
  }
}

TEST(Repaired_solids, a_fin_is_cut_off)
{
  const Mesh cube = boundary({{0, 0, 0}});
  for (const double x : {-1., 0.25}) // outside, inside
    for (const bool is_turned : {false, true}) {
      Mesh mesh = cube;
      append(mesh, {{{0, 0, 0}, {0, 0, 1}, {x, x, 0.5}}, {{0, 1, 2}}});
      if (is_turned)
        turn_over(mesh.faces.back());
      const IT::Repaired_polygons repaired = expect_surface(mesh, 3, 1);
      EXPECT_EQ(volumes(repaired).size(), 2u);
      EXPECT_EQ(IT::message(repaired.repairs.back()),
                "edge 0-3 of face 12 became border: of its 3 faces, no other one was left that fits");
    }
}

TEST(Repaired_solids, of_two_rooms_one_stays_closed)
{
  std::set<Cell> cells{{0, 0, 0}, {1, 0, 0}};
  Mesh mesh = boundary(cells);
  append(mesh, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}});
  const IT::Repaired_polygons repaired = expect_surface(mesh, 4, 4);
  EXPECT_EQ(volumes(repaired).size(), 2u);
}

TEST(Repaired_solids, of_three_sheets_two_that_meet_leave_no_slit)
{
  // The first and the fifth face meet at edge 2-5, where four faces pair up, and at edge 2-4.
  expect_surface({{{66, 79, 47}, {70, 34, 33}, {84, 30, 29}, {27, 76, 5}, {98, 82, 55}, {41, 74, 10}, {25, 18, 14}},
                  {{2, 5, 3}, {5, 0, 2}, {2, 6, 5}, {2, 4, 3}, {4, 5, 2}, {0, 5, 6}, {4, 2, 0}}},
                 7, 1);
}

TEST(Repaired_solids, a_hole_stays_the_only_hole)
{
  std::mt19937 random(9);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    Mesh mesh = boundary(round < 20 ? six_cells : random_cells(random, 3, 0.4));
    mesh.faces.erase(mesh.faces.begin() + std::ptrdiff_t(random() % mesh.faces.size()));
    const IT::Surface_report before = IT::examine_polygons(mesh.points, mesh.faces);
    if (before.number_of_border_edges == 3)
      expect_surface(mesh, 3, 0);
  }
}

TEST(Repaired_solids, a_triangle_given_twice_leaves_a_border_that_is_told)
{
  const IT::Repaired_polygons repaired =
    IT::repair_polygons(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}, {2, 1, 0}});
  EXPECT_EQ(count(repaired, IT::Repair_kind::OPENED_EDGE), 3u);
  EXPECT_EQ(IT::message(repaired.repairs.back()),
            "edge 0-1 of face 0 became border: its two faces do not fit, or one was removed, and 2 more edges like it");
}

} // namespace
