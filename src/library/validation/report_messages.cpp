// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The sentences that report the defects and gaps of a surface.

#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

// The name of a defect, its number, and the remedy.
struct Finding_words
{
  const char* singular; // the element that `count` counts
  const char* plural;
  const char* summary; // completes "3 ..."
  const char* advice;
};

inline Finding_words words_of(const Finding& finding)
{
  using Defect = Invalid_surface_error::Defect;
  switch (finding.defect) {
  case Defect::EMPTY:
    return {"file", "files", "without a face", "at least one triangle is needed"};
  case Defect::BAD_INDEX:
    return {"face", "faces", "with a bad index",
            "vertices are counted from 0 here: remove the face, or add the missing vertices"};
  case Defect::NOT_FINITE:
    return {"vertex", "vertices", "not finite", "give every vertex finite coordinates"};
  case Defect::NOT_A_TRIANGLE:
    return {"face", "faces", "not a triangle", "triangulate the faces, as repair_polygons() does"};
  case Defect::REPEATED_CORNER:
    return {"face", "faces", "with a repeated corner",
            "remove the face, or cut it into loops, as repair_polygons() does"};
  case Defect::DUPLICATE_FACE:
    return {"face", "faces", "repeating another", "remove all but one, as repair_polygons() does"};
  case Defect::NON_MANIFOLD_EDGE:
    return {"edge", "edges", "not manifold",
            "remove the faces that do not belong there, or separate those that do, as repair_polygons() does"};
  case Defect::INCONSISTENT_ORIENTATION:
    return {"edge", "edges", "with faces of opposite orientation", "orient the faces, as repair_polygons() does"};
  case Defect::NON_MANIFOLD_VERTEX:
    return {"vertex", "vertices", "not manifold", "give each fan a vertex of its own, as repair_polygons() does"};
  case Defect::ZERO_LENGTH_EDGE:
    return {"edge", "edges", "of zero length",
            "merge the two vertices and remove the faces that vanish, as repair_polygons() does, or move one of them"};
  case Defect::OUT_OF_RANGE:
    if (finding.elements.empty())
      return {"element", "elements", "too many", "split the surface"};
    if (finding.edges.empty())
      return {"vertex", "vertices", "out of range",
              "no scaling brings both into the range of double: round it to zero, or remove the outliers"};
    return {
      "edge", "edges", "out of range",
      "no scaling brings both squared lengths, and their products, into the range of double: remove the outliers"};
  case Defect::DEGENERATE_FACE:
    if (finding.is_fatal)
      return {"flat spike", "flat spikes", "with no room for triangles",
              "remove the vertex and its faces, as repair_polygons() does: no area is lost"};
    return {"face", "faces", "of zero area", ""};
  case Defect::UNREFERENCED_VERTEX:
    return {"vertex", "vertices", "not referenced by any face", ""};
  default:
    return {"component", "components", "in all", ""};
  }
}

} // namespace internal

std::string message(const Finding& finding, const std::optional<std::string>& advice)
{
  const internal::Finding_words words = internal::words_of(finding);
  std::string text = finding.description;
  if (finding.count > 1 && finding.defect != Invalid_surface_error::Defect::SEVERAL_COMPONENTS)
    text += ", and " + std::to_string(finding.count - 1) + " more " +
            (finding.count == 2 ? words.singular : words.plural) + " like it";
  const std::string what_to_do = advice.value_or(words.advice);
  if (!what_to_do.empty())
    text += "; " + what_to_do;
  return text;
}

std::string message(const Gap& gap, const std::optional<std::string>& advice)
{
  const bool is_junction = gap.kind == Gap_kind::T_JUNCTION;
  std::string text = gap.description;
  if (gap.count > 1)
    text += ", and " + std::to_string(gap.count - 1) + " more " + (is_junction ? "T-junction" : "pair") +
            (gap.count == 2 ? "" : "s") + " like it";
  return text + "; " +
         advice.value_or(is_junction ? "ways go around the gap: split the edge there, as repair_polygons() does if a "
                                       "stitching tolerance is given"
                                     : "merge them if they are to be one, as repair_polygons() does if a stitching "
                                       "tolerance is given");
}

std::string message(const Surface_report& report, const std::string& name, const std::optional<std::string>& advice)
{
  std::string text;
  const Finding* const fatal = report.first_fatal();
  if (fatal != nullptr) {
    text = message(*fatal, advice);
    std::string others;
    for (const Finding& finding : report.findings) {
      if (!finding.is_fatal || &finding == fatal)
        continue;
      const internal::Finding_words words = internal::words_of(finding);
      others += (others.empty() ? " (also: " : ", ") + std::to_string(finding.count) + " " +
                (finding.count == 1 ? words.singular : words.plural) + " " + words.summary;
    }
    text += others.empty() ? others : others + ")";
  } else {
    for (const Finding& finding : report.findings)
      text += (text.empty() ? "" : "; ") + message(finding);
    for (const Gap& gap : report.gaps)
      text += (text.empty() ? "" : "; ") + message(gap);
  }
  return name.empty() || text.empty() ? text : name + ": " + text;
}

void throw_if_fatal(const Surface_report& report, const std::string& name)
{
  const Finding* const fatal = report.first_fatal();
  if (fatal != nullptr)
    throw Invalid_surface_error(fatal->defect, fatal->elements.empty() ? 0 : fatal->elements.front(), fatal->count,
                                message(report, name));
}

} // namespace CGAL::Intrinsic_triangulations
