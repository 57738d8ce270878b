// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Surface_report.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REPORTS_SURFACE_REPORT_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REPORTS_SURFACE_REPORT_IMPL_H

#include <CGAL/Intrinsic_triangulations/Surface_report.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE const Finding_properties& finding_properties(const Finding_kind kind)
{
  typedef Invalid_surface_error::Defect Defect;
  static const Finding_properties table[] = {
    {Defect::EMPTY, true, "file", "files", "without a face",
     "at least one triangle is needed"},
    {Defect::OUT_OF_RANGE, true, "element", "elements", "too many",
     "split the surface"},
    {Defect::BAD_INDEX, true, "face", "faces", "with a bad index",
     "vertices are counted from 0 here: remove the face, or add the missing vertices"},
    {Defect::NOT_FINITE, true, "vertex", "vertices", "not finite",
     "give every vertex finite coordinates"},
    {Defect::NOT_A_TRIANGLE, true, "face", "faces", "not a triangle",
     "triangulate the faces, as repair_polygons() does"},
    {Defect::REPEATED_CORNER, true, "face", "faces", "with a repeated corner",
     "remove the face, or cut it into loops, as repair_polygons() does"},
    {Defect::DUPLICATE_FACE, true, "face", "faces", "repeating another",
     "remove all but one, as repair_polygons() does"},
    {Defect::NON_MANIFOLD_EDGE, true, "edge", "edges", "not manifold",
     "remove the faces that do not belong there, or separate those that do, as repair_polygons() does"},
    {Defect::INCONSISTENT_ORIENTATION, true, "edge", "edges", "with faces of opposite orientation",
     "orient the faces, as repair_polygons() does"},
    {Defect::NON_MANIFOLD_VERTEX, true, "vertex", "vertices", "not manifold",
     "give each fan a vertex of its own, as repair_polygons() does"},
    {Defect::ZERO_LENGTH_EDGE, true, "edge", "edges", "of zero length",
     "merge the two vertices and remove the faces that vanish, as repair_polygons() does, or move one of them"},
    {Defect::OUT_OF_RANGE, true, "vertex", "vertices", "out of range",
     "no scaling brings both into the range of double: round it to zero, or remove the outliers"},
    {Defect::OUT_OF_RANGE, true, "edge", "edges", "out of range",
     "no scaling brings both squared lengths, and their products, into the range of double: remove the outliers"},
    {Defect::DEGENERATE_FACE, false, "face", "faces", "of zero area", ""},
    {Defect::EMPTY, false, "vertex", "vertices", "not referenced by any face", ""},
    {Defect::EMPTY, false, "component", "components", "in all", ""}};
  return table[static_cast<std::size_t>(kind)];
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string message(const Finding& finding, const std::optional<std::string>& advice)
{
  const internal::Finding_properties& properties = internal::finding_properties(finding.kind);
  std::string text = finding.description;
  if (finding.count > 1 && finding.kind != Finding_kind::SEVERAL_COMPONENTS)
    text += ", and " + std::to_string(finding.count - 1) + " more " +
            (finding.count == 2 ? properties.singular : properties.plural) + " like it";
  const std::string what_to_do = advice.value_or(properties.advice);
  if (!what_to_do.empty())
    text += "; " + what_to_do;
  return text;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string message(const Surface_report& report, const std::string& name,
                                                         const std::optional<std::string>& advice)
{
  std::string text;
  const Finding* const fatal = report.first_fatal();
  if (fatal != nullptr) {
    text = message(*fatal, advice);
    std::string others;
    for (const Finding& finding : report.findings) {
      if (!finding.is_fatal || &finding == fatal)
        continue;
      const internal::Finding_properties& properties = internal::finding_properties(finding.kind);
      others += (others.empty() ? " (also: " : ", ") + std::to_string(finding.count) + " " +
                (finding.count == 1 ? properties.singular : properties.plural) + " " + properties.summary;
    }
    text += others.empty() ? others : others + ")";
  } else
    for (const Finding& finding : report.findings)
      text += (text.empty() ? "" : "; ") + message(finding);
  return name.empty() || text.empty() ? text : name + ": " + text;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void throw_if_fatal(const Surface_report& report, const std::string& name)
{
  const Finding* const fatal = report.first_fatal();
  if (fatal != nullptr)
    throw Invalid_surface_error(fatal->defect, fatal->elements.empty() ? 0 : fatal->elements.front(),
                                fatal->count, message(report, name));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REPORTS_SURFACE_REPORT_IMPL_H
