// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The passes over a list of polygons that find what is wrong with it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SURFACE_EXAMINER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SURFACE_EXAMINER_H

#include <CGAL/Intrinsic_triangulations/Surface_report.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Length_range.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Element_collector.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Polygon_sides.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/polygon_texts.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Examines one list of polygons, in passes over the flat arrays of Polygon_sides.
template <class PointRange>
class Surface_examiner
{
public:
  typedef std::array<double, 3> Coordinates;

  explicit Surface_examiner(const PointRange& points)
    : points_(std::begin(points)),
      number_of_vertices_(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))))
  {}

  template <class PolygonRange>
  Surface_report examine(const PolygonRange& polygons)
  {
    report_.number_of_vertices = number_of_vertices_;
    if (flatten(polygons)) {
      examine_coordinates();
      examine_faces();
      polygons_.sort_sides(number_of_vertices_);
      examine_edges();
      examine_lengths();
      examine_use();
    }
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
    return std::move(report_);
  }

private:
  typedef Polygon_sides::Index Index;
  typedef Polygon_sides::Side Side;
  static constexpr Index none_ = Polygon_sides::none;

  // The sides of the edge from the current bucket's vertex to this one.
  struct Edge_mark
  {
    Index bucket, first_side, count;
    bool same_direction, same_third;
  };

  Coordinates coordinates(const std::size_t vertex) const
  {
    const auto& point = points_[static_cast<std::ptrdiff_t>(vertex)];
    return Coordinates{{CGAL::to_double(point[0]), CGAL::to_double(point[1]), CGAL::to_double(point[2])}};
  }
  Finding& add(const Finding_kind kind, const std::size_t count, std::vector<std::size_t> elements,
               std::string description)
  {
    const Finding_properties& properties = finding_properties(kind);
    report_.findings.push_back(Finding{
      kind, properties.defect, std::move(elements), {}, count, properties.is_fatal, std::move(description)});
    return report_.findings.back();
  }
  // The elements of `edges` are positions in sides_ of the first sides of edges.
  void add_edges(const Finding_kind kind, const Element_collector& edges, std::string description)
  {
    Finding& finding = add(kind, edges.count(), {}, std::move(description));
    for (const std::size_t s : edges.elements()) {
      finding.elements.push_back(polygons_.face_of_side(s));
      finding.edges.push_back(polygons_.ends(s));
    }
  }
  // Copies the corners, and returns whether there is something to examine.
  template <class PolygonRange>
  bool flatten(const PolygonRange& polygons)
  {
    const std::size_t n = number_of_vertices_;
    const std::size_t number_of_faces =
      static_cast<std::size_t>(std::distance(std::begin(polygons), std::end(polygons)));
    report_.number_of_faces = number_of_faces;
    if (number_of_faces == 0) {
      add(Finding_kind::EMPTY, 1, {},
          n == 0 ? "there is no vertex and no face"
                 : "there " + are_counted(n, "vertex", "vertices") + " but no face");
      return false;
    }
    if (n >= none_ || number_of_faces >= none_ / 3) {
      add(Finding_kind::TOO_MANY_ELEMENTS, 1, {},
          std::to_string(n) + " vertices and " + std::to_string(number_of_faces) +
            " faces are more than 32-bit indices can number");
      return false;
    }
    is_used_.assign(n, 0);
    polygons_.reserve(number_of_faces);
    std::size_t face = 0, bad_value = 0;
    for (const auto& polygon : polygons) {
      bool is_good = true;
      for (const auto index : polygon) {
        const std::size_t value = static_cast<std::size_t>(index);
        if (value < n)
          is_used_[value] = 1;
        else if (is_good) {
          is_good = false;
          if (bad_index_.count() == 0)
            bad_value = value;
        }
        polygons_.add_corner(value);
      }
      if (!is_good)
        bad_index_.add(face);
      polygons_.end_face(is_good);
      if (polygons_.number_of_corners() >= none_) {
        add(Finding_kind::TOO_MANY_ELEMENTS, 1, {}, "the faces have more corners than 32-bit indices can number");
        return false;
      }
      ++face;
    }
    if (bad_index_.count() != 0)
      add(Finding_kind::BAD_INDEX, bad_index_.count(), bad_index_.elements(),
          "face " + std::to_string(bad_index_.first()) + " names vertex " + index_text(bad_value) +
            ", but there " + are_counted(n, "vertex", "vertices"));
    return true;
  }

  void examine_coordinates()
  {
    Element_collector bad;
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      const Coordinates p = coordinates(v);
      if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
        bad.add(v);
      else if (is_used_[v])
        for (int i = 0; i < 3; ++i)
          box_.add(i, p[i]);
    }
    all_finite_ = bad.count() == 0;
    if (all_finite_) {
      examine_scaled_coordinates();
      return;
    }
    const Coordinates p = coordinates(bad.first());
    std::ostringstream text;
    text.precision(17);
    text << "vertex " << bad.first() << " has the coordinates (" << p[0] << ", " << p[1] << ", " << p[2] << ")";
    add(Finding_kind::NOT_FINITE, bad.count(), bad.elements(), text.str());
  }

  // What the constructors refuse to scale.
  void examine_scaled_coordinates()
  {
    exponent_ = unit_exponent<double>(box_.half_extent());
    if (exponent_ == 0)
      return;
    Element_collector vanishing;
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      if (Coordinates p = coordinates(v); is_used_[v] && !scale_point(p, box_, exponent_))
        vanishing.add(v);
    if (vanishing.count() == 0)
      return;
    const Coordinates p = coordinates(vanishing.first());
    std::ostringstream text;
    text << "vertex " << vanishing.first() << " at (" << p[0] << ", " << p[1] << ", " << p[2]
         << ") has a coordinate that is lost beside the size of the surface, about " << 2 * box_.half_extent();
    add(Finding_kind::COORDINATE_RANGE, vanishing.count(), vanishing.elements(), text.str());
  }

  // Number of corners, repeated corners and zero areas.
  void examine_faces()
  {
    Element_collector not_triangles, repeated, flat;
    std::vector<Index> last_face(polygons_.are_triangles() ? 0 : number_of_vertices_, none_); // for polygons only
    for (std::size_t f = 0; f < report_.number_of_faces; ++f) {
      const std::size_t begin = polygons_.begin_of_face(f), end = polygons_.begin_of_face(f + 1);
      if (end - begin != 3)
        not_triangles.add(f);
      if (begin == end || polygons_.vertex(begin) == none_)
        continue;
      if (end - begin == 3) {
        const Index a = polygons_.vertex(begin), b = polygons_.vertex(begin + 1), c = polygons_.vertex(begin + 2);
        if (a == b || b == c || c == a)
          repeated.add(f);
        else if (all_finite_ && are_collinear(coordinates(a), coordinates(b), coordinates(c)))
          flat.add(f);
        continue;
      }
      bool is_repeated = false;
      for (std::size_t c = begin; c < end; ++c) {
        is_repeated = is_repeated || last_face[polygons_.vertex(c)] == f;
        last_face[polygons_.vertex(c)] = static_cast<Index>(f);
      }
      if (is_repeated)
        repeated.add(f);
    }
    if (not_triangles.count() != 0) {
      const std::size_t f = not_triangles.first(), corners = polygons_.degree(f);
      const bool has_text = corners != 0 && polygons_.vertex(polygons_.begin_of_face(f)) != none_;
      add(Finding_kind::NOT_A_TRIANGLE, not_triangles.count(), not_triangles.elements(),
          "face " + (has_text ? face_text(polygons_, f) : std::to_string(f)) + " has " + std::to_string(corners) +
            (corners == 1 ? " corner" : " corners") + " instead of 3");
    }
    if (repeated.count() != 0)
      add(Finding_kind::REPEATED_CORNER, repeated.count(), repeated.elements(),
          "face " + face_text(polygons_, repeated.first()) + " names a vertex twice");
    if (flat.count() != 0)
      add(Finding_kind::ZERO_AREA_FACE, flat.count(), flat.elements(),
          "face " + face_text(polygons_, flat.first()) + " has zero area");
  }

  void examine_edges()
  {
    Element_collector crowded, turned, coincident, duplicates;
    std::vector<Edge_mark> marks(number_of_vertices_, Edge_mark{none_, 0, 0, false, false});
    std::vector<std::array<Index, 3>> crowded_faces; // other, third, face
    Disjoint_sets fans(polygons_.number_of_corners());
    Length_range lengths;
    for (std::size_t a = 0; a < number_of_vertices_; ++a) {
      const std::size_t begin = polygons_.bucket_begin(a), end = polygons_.bucket_begin(a + 1);
      for (std::size_t s = begin; s < end; ++s) {
        const Side& side = polygons_.side(s);
        Edge_mark& mark = marks[side.other];
        if (mark.bucket != a) {
          mark = Edge_mark{static_cast<Index>(a), static_cast<Index>(s), 1, false, false};
          continue;
        }
        const Side& first = polygons_.side(mark.first_side);
        const bool same_direction = polygons_.leaves(side, a) == polygons_.leaves(first, a);
        fans.unite(same_direction ? side.source : side.target, first.source);
        fans.unite(same_direction ? side.target : side.source, first.target);
        if (++mark.count == 2) {
          const Index third = polygons_.third_vertex(side);
          mark.same_direction = same_direction;
          mark.same_third = third != none_ && third > side.other && third == polygons_.third_vertex(first);
        }
      }
      bool is_crowded = false;
      for (std::size_t s = begin; s < end; ++s) {
        const Side& side = polygons_.side(s);
        const Edge_mark& mark = marks[side.other];
        if (mark.first_side == s) {
          ++report_.number_of_edges;
          report_.number_of_border_edges += mark.count == 1;
          if (!lengths.add(coordinates(a), coordinates(side.other), s))
            coincident.add(s);
          if (mark.count > 2) {
            crowded.add(s);
            is_crowded = true;
          } else if (mark.same_direction)
            turned.add(s);
        } else if (mark.count == 2 && mark.same_third)
          duplicates.add(polygons_.face_of_corner(side.source));
      }
      if (is_crowded)
        find_duplicates_in_bucket(begin, end, marks, crowded_faces, duplicates);
    }
    report_.is_orientable = turned.count() == 0 || (crowded.count() == 0 && is_orientable(marks));
    if (duplicates.count() != 0)
      add(Finding_kind::DUPLICATE_FACE, duplicates.count(), duplicates.elements(),
          "face " + face_text(polygons_, duplicates.first()) + " has the same corners as face " +
            std::to_string(first_face_like(duplicates.first())));
    if (crowded.count() != 0)
      add_edges(Finding_kind::NON_MANIFOLD_EDGE, crowded,
                edge_text(polygons_, crowded.first()) + " has " + std::to_string(number_of_faces_at(crowded.first())) +
                  " faces (" + faces_text(polygons_, crowded.first()) + ")");
    if (turned.count() != 0)
      add_edges(Finding_kind::INCONSISTENT_ORIENTATION, turned,
                edge_text(polygons_, turned.first()) + " is traversed in the same direction by both its faces (" +
                  faces_text(polygons_, turned.first()) +
                  (report_.is_orientable || crowded.count() != 0
                     ? ")"
                     : ") and the surface is one-sided, so that no choice of directions fits"));
    if (coincident.count() != 0)
      add_edges(Finding_kind::ZERO_LENGTH_EDGE, coincident,
                edge_text(polygons_, coincident.first()) + " of " + faces_text(polygons_, coincident.first()) +
                  " has zero length, its ends coincide");
    count_fans(fans);
    if (all_finite_)
      lengths_ = lengths;
  }
  std::size_t number_of_faces_at(const std::size_t side) const
  {
    std::size_t count = 0;
    polygons_.for_each_face_of_edge(side, [&count](std::size_t) {
      ++count;
      return true;
    });
    return count;
  }
  // Among the faces at the edges of a bucket that have more than two.
  void find_duplicates_in_bucket(const std::size_t begin, const std::size_t end,
                                 const std::vector<Edge_mark>& marks,
                                 std::vector<std::array<Index, 3>>& faces, Element_collector& duplicates) const
  {
    faces.clear();
    for (std::size_t s = begin; s < end; ++s) {
      if (marks[polygons_.side(s).other].count <= 2)
        continue;
      const Index third = polygons_.third_vertex(polygons_.side(s));
      if (third != none_ && third > polygons_.side(s).other)
        faces.push_back({{polygons_.side(s).other, third, static_cast<Index>(polygons_.face_of_side(s))}});
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (faces[i][0] == faces[i - 1][0] && faces[i][1] == faces[i - 1][1])
        duplicates.add(faces[i][2]);
  }
  std::size_t first_face_like(const std::size_t face) const
  {
    const auto sorted_corners = [this](const std::size_t f) {
      const std::size_t c = polygons_.begin_of_face(f);
      std::array<Index, 3> v = {{polygons_.vertex(c), polygons_.vertex(c + 1), polygons_.vertex(c + 2)}};
      std::sort(v.begin(), v.end());
      return v;
    };
    const std::array<Index, 3> v = sorted_corners(face);
    std::size_t f = 0;
    while (f != face && (polygons_.degree(f) != 3 || sorted_corners(f) != v))
      ++f;
    return f;
  }
  // Can the faces be turned to agree? Each face has two nodes, itself and
  // itself turned; a one-sided surface connects them. Only when edges disagree.
  bool is_orientable(std::vector<Edge_mark>& marks) const
  {
    const Index f = static_cast<Index>(report_.number_of_faces);
    Disjoint_sets turns(2 * std::size_t(f));
    marks.assign(marks.size(), Edge_mark{none_, 0, 0, false, false});
    for (std::size_t a = 0; a < number_of_vertices_; ++a)
      for (std::size_t s = polygons_.bucket_begin(a); s < polygons_.bucket_begin(a + 1); ++s) {
        Edge_mark& mark = marks[polygons_.side(s).other];
        if (mark.bucket != a) {
          mark.bucket = static_cast<Index>(a);
          mark.first_side = static_cast<Index>(s);
          continue;
        }
        const Side& first = polygons_.side(mark.first_side);
        const Index x = static_cast<Index>(polygons_.face_of_corner(first.source));
        const Index y = static_cast<Index>(polygons_.face_of_side(s));
        const bool same = polygons_.leaves(first, a) == polygons_.leaves(polygons_.side(s), a);
        turns.unite(x, same ? y + f : y);
        turns.unite(x + f, same ? y : y + f);
      }
    for (Index x = 0; x < f; ++x)
      if (turns.find(x) == turns.find(x + f))
        return false;
    return true;
  }

  void examine_lengths()
  {
    if (lengths_.is_empty())
      return;
    report_.exponent_of_longest_edge = lengths_.exponent_of_longest();
    report_.exponent_of_shortest_edge = lengths_.exponent_of_shortest();
    if (!lengths_.vanishes_in_unit(exponent_))
      return;
    Element_collector shortest;
    shortest.add(lengths_.shortest_edge());
    std::ostringstream text;
    text << edge_text(polygons_, lengths_.shortest_edge()) << " (length about " << lengths_.shortest() << ") and "
         << edge_text(polygons_, lengths_.longest_edge()) << " (length about ";
    if (std::isinf(lengths_.longest()))
      text << "2^1024";
    else
      text << lengths_.longest();
    text << ") differ by a factor of about 2^"
         << report_.exponent_of_longest_edge - report_.exponent_of_shortest_edge;
    add_edges(Finding_kind::LENGTH_RANGE, shortest, text.str());
  }

  // The corners at a vertex that are connected through sides are one fan.
  void count_fans(Disjoint_sets& fans)
  {
    number_of_fans_.assign(number_of_vertices_, 0);
    Element_collector pinched;
    for (std::size_t f = 0; f < report_.number_of_faces; ++f) {
      const std::size_t begin = polygons_.begin_of_face(f), end = polygons_.begin_of_face(f + 1);
      if (end - begin < 3 || polygons_.vertex(begin) == none_)
        continue;
      for (std::size_t c = begin; c < end; ++c)
        if (fans.find(static_cast<Index>(c)) == c)
          ++number_of_fans_[polygons_.vertex(c)];
    }
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      if (number_of_fans_[v] > 1)
        pinched.add(v);
    if (pinched.count() == 0)
      return;
    std::string faces;
    std::size_t written = 0;
    for (std::size_t c = 0; c < polygons_.number_of_corners() && written < 2; ++c)
      if (polygons_.vertex(c) == pinched.first() && fans.find(static_cast<Index>(c)) == c)
        faces += (written++ == 0 ? "one with face " : ", another with face ") +
                 std::to_string(polygons_.face_of_corner(c));
    add(Finding_kind::NON_MANIFOLD_VERTEX, pinched.count(), pinched.elements(),
        "the faces around vertex " + std::to_string(pinched.first()) + " form " +
          std::to_string(number_of_fans_[pinched.first()]) + " fans that touch only there (" + faces + ")");
  }
  void examine_use()
  {
    Disjoint_sets pieces(number_of_vertices_);
    polygons_.for_each_side([&](const Index s, const Index t) { pieces.unite(polygons_.vertex(s), polygons_.vertex(t)); });
    Element_collector unused, roots;
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      if (!is_used_[v])
        unused.add(v);
      else if (pieces.find(static_cast<Index>(v)) == v)
        roots.add(v);
    }
    report_.number_of_components = roots.count();
    if (unused.count() != 0)
      add(Finding_kind::UNREFERENCED_VERTEX, unused.count(), unused.elements(),
          "vertex " + std::to_string(unused.first()) + " is not referenced by any face");
    if (roots.count() > 1)
      add(Finding_kind::SEVERAL_COMPONENTS, roots.count(), roots.elements(),
          "the surface has " + std::to_string(roots.count()) + " components");
  }

  decltype(std::begin(std::declval<const PointRange&>())) points_;
  std::size_t number_of_vertices_;
  Polygon_sides polygons_;
  bool all_finite_ = true;
  std::vector<unsigned char> is_used_;
  Element_collector bad_index_;
  std::vector<Index> number_of_fans_;
  Box box_; // of the vertices that are used
  int exponent_ = 0;
  Length_range lengths_;
  Surface_report report_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SURFACE_EXAMINER_H
