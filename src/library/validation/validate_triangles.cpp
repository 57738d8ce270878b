// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The passes over a list of polygons that find its defects.

#include <CGAL/Intrinsic_triangulations/validate_triangles.h>
#include "../gluing/Surface_gluer.h"
#include "Gap_search.h"
#include "Polygon_sides.h"
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

using Defect = Invalid_surface_error::Defect;

inline std::string face_text(const Polygon_sides& polygons, const std::size_t face)
{
  std::ostringstream text;
  text << face << " (corners ";
  const std::size_t begin = polygons.begin_of_face(face), end = polygons.begin_of_face(face + 1);
  for (std::size_t c = begin; c < end && c < begin + 8; ++c)
    text << (c == begin ? "" : ", ") << polygons.vertex(c);
  text << (end > begin + 8 ? ", ...)" : ")");
  return text.str();
}

inline std::string edge_text(const Polygon_sides& polygons, const std::size_t side)
{
  const std::array<std::size_t, 2> v = polygons.ends(side);
  return "edge " + std::to_string(v[0]) + "-" + std::to_string(v[1]);
}

inline std::string faces_text(const Polygon_sides& polygons, const std::size_t side)
{
  const std::vector<std::size_t> faces = polygons.faces_of_edge(side);
  std::string text = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < faces.size() && i < 8; ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(faces[i]);
  return text + (faces.size() > 8 ? ", ..." : "");
}

// Examines one list of polygons, in passes over the flat arrays of Polygon_sides.
class Surface_examiner
{
  using Coordinates = std::array<double, 3>;

public:
  explicit Surface_examiner(Polygon_copies&& polygons)
    : points_(std::move(polygons.points)), polygons_(std::move(polygons))
  {}

  // Examines what no repair can change: numbers and coordinates.
  Surface_report examine_data()
  {
    report_.number_of_vertices = number_of_vertices_;
    report_.number_of_faces = polygons_.number_of_faces();
    if (examine_numbers())
      examine_coordinates();
    return std::move(report_);
  }

  Surface_report examine(bool only_gaps)
  {
    report_.number_of_vertices = number_of_vertices_;
    report_.number_of_faces = polygons_.number_of_faces();
    if (examine_numbers()) {
      examine_coordinates();
      if (!only_gaps)
        examine_faces();
      polygons_.sort_sides();
      examine_edges();
      examine_lengths();
      if (!only_gaps)
        examine_use();
      if (all_finite_) {
        examine_spikes();
        Gap_search(points_, polygons_, border_, report_).add_gaps(are_sheets_meeting_);
      }
    }
    if (only_gaps)
      report_.findings.clear();
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.defect < b.defect; });
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

  const Coordinates& point(const std::size_t vertex) const { return points_[vertex]; }
  Finding& add(const Defect defect, const std::size_t count, std::vector<std::size_t> elements, std::string description)
  {
    report_.findings.push_back(
      Finding{defect, std::move(elements), {}, count, defect <= Defect::OUT_OF_RANGE, std::move(description)});
    return report_.findings.back();
  }
  // \param describe describes the defect of the first element
  template <class Describe>
  void add(const Defect defect, const Element_collector& elements, const Describe& describe)
  {
    if (elements.count() != 0)
      add(defect, elements.count(), elements.elements(), describe(elements.first()));
  }
  // The elements of `edges` are positions in sides_ of the first sides of edges.
  template <class Describe>
  void add_edges(const Defect defect, const Element_collector& edges, const Describe& describe)
  {
    if (edges.count() == 0)
      return;
    Finding& finding = add(defect, edges.count(), {}, describe(edges.first()));
    for (const std::size_t s : edges.elements()) {
      finding.elements.push_back(polygons_.face_of_side(s));
      finding.edges.push_back(polygons_.ends(s));
    }
  }
  // Reports the defects that were seen while the polygons were copied. Returns whether there is more to examine.
  bool examine_numbers()
  {
    const std::size_t n = number_of_vertices_, number_of_faces = report_.number_of_faces;
    if (number_of_faces == 0)
      add(Defect::EMPTY, 1, {},
          n == 0 ? "there is no vertex and no face" : "there " + are_counted(n, "vertex", "vertices") + " but no face");
    else if (!polygons_.can_be_numbered())
      add(Defect::OUT_OF_RANGE, 1, {},
          n >= none_ || number_of_faces >= none_ / 3
            ? std::to_string(n) + " vertices and " + std::to_string(number_of_faces) +
                " faces are more than 32-bit indices can number"
            : "the faces have more corners than 32-bit indices can number");
    if (!report_.findings.empty())
      return false;
    add(Defect::BAD_INDEX, polygons_.faces_with_bad_index(), [&](const std::size_t f) {
      return "face " + std::to_string(f) + " names vertex " + index_text(polygons_.first_bad_index()) + ", but there " +
             are_counted(n, "vertex", "vertices");
    });
    return true;
  }

  void examine_coordinates()
  {
    Element_collector bad;
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      const Coordinates p = point(v);
      if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
        bad.add(v);
      else if (polygons_.is_used(v))
        for (int i = 0; i < 3; ++i)
          box_.add(i, p[i]);
    }
    all_finite_ = bad.count() == 0;
    if (all_finite_)
      examine_scaled_coordinates();
    add(Defect::NOT_FINITE, bad, [this](const std::size_t v) {
      const Coordinates p = point(v);
      std::ostringstream text;
      text.precision(17);
      text << "vertex " << v << " has the coordinates (" << p[0] << ", " << p[1] << ", " << p[2] << ")";
      return text.str();
    });
  }

  // Finds coordinates that the constructors refuse to scale.
  void examine_scaled_coordinates()
  {
    exponent_ = unit_exponent<double>(box_.half_extent());
    if (exponent_ == 0)
      return;
    Element_collector vanishing;
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      if (Coordinates p = point(v); polygons_.is_used(v) && !scale_point(p, box_, exponent_))
        vanishing.add(v);
    add(Defect::OUT_OF_RANGE, vanishing, [this](const std::size_t v) {
      const Coordinates p = point(v);
      std::ostringstream text;
      text << "vertex " << v << " at (" << p[0] << ", " << p[1] << ", " << p[2]
           << ") has a coordinate that is lost beside the size of the surface, about " << 2 * box_.half_extent();
      return text.str();
    });
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
        else if (all_finite_ && are_collinear(point(a), point(b), point(c)))
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
    add(Defect::NOT_A_TRIANGLE, not_triangles, [this](const std::size_t f) {
      const std::size_t corners = polygons_.degree(f);
      const bool has_text = corners != 0 && polygons_.vertex(polygons_.begin_of_face(f)) != none_;
      return "face " + (has_text ? face_text(polygons_, f) : std::to_string(f)) + " has " +
             counted(corners, "corner", "corners") + " instead of 3";
    });
    const auto face = [this](const std::size_t f) { return "face " + face_text(polygons_, f); };
    add(Defect::REPEATED_CORNER, repeated, [&](const std::size_t f) { return face(f) + " names a vertex twice"; });
    add(Defect::DEGENERATE_FACE, flat, [&](const std::size_t f) { return face(f) + " has zero area"; });
    has_flat_faces_ = flat.count() > 0;
  }

  // Vertices around which all faces are flat, with an angle of zero: no triangulation is Delaunay there.
  void examine_spikes()
  {
    if (!has_flat_faces_)
      return;
    std::vector<bool> is_tip(number_of_vertices_, true);
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      is_tip[v] = polygons_.is_used(v);
    for (std::size_t f = 0; f < report_.number_of_faces; ++f) {
      const std::size_t begin = polygons_.begin_of_face(f), end = polygons_.begin_of_face(f + 1);
      if (begin == end || polygons_.vertex(begin) == none_)
        continue;
      std::array<Index, 3> v = {};
      for (std::size_t i = 0; i < 3 && end - begin == 3; ++i)
        v[i] = polygons_.vertex(begin + i);
      const bool is_flat = end - begin == 3 && are_collinear(point(v[0]), point(v[1]), point(v[2]));
      for (std::size_t i = 0; i < end - begin; ++i)
        if (!is_flat || is_between(point(v[i]), point(v[(i + 1) % 3]), point(v[(i + 2) % 3])))
          is_tip[polygons_.vertex(begin + i)] = false;
    }
    for (const Index s : border_)
      for (const std::size_t v : polygons_.ends(s))
        is_tip[v] = false; // a border leaves room
    Element_collector tips;
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      if (is_tip[v])
        tips.add(v);
    if (tips.count() == 0)
      return;
    add(Defect::DEGENERATE_FACE, tips, [this](const std::size_t v) {
      std::string faces;
      std::size_t n = 0;
      for (std::size_t c = 0; c < polygons_.number_of_corners(); ++c)
        if (polygons_.vertex(c) == v && n++ < 8)
          faces += (n == 1 ? "" : ", ") + std::to_string(polygons_.face_of_corner(c));
      return "all faces around vertex " + std::to_string(v) + " (faces " + faces + (n > 8 ? ", ..." : "") +
             ") have zero area and an angle of zero there";
    });
    Finding& finding = report_.findings.back();
    finding.is_fatal = true;
    for (std::size_t& element : finding.elements)
      element = first_face(element);
  }
  std::size_t first_face(const std::size_t vertex) const
  {
    std::size_t c = 0;
    while (polygons_.vertex(c) != vertex)
      ++c;
    return polygons_.face_of_corner(c);
  }
  // On a line, points are in the order of their coordinates.
  static bool is_between(const Coordinates& p, const Coordinates& q, const Coordinates& r)
  {
    return (q < p) != (r < p);
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
          if (mark.count == 1)
            border_.push_back(static_cast<Index>(s));
          if (!lengths.add(point(a), point(side.other), s))
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
    are_sheets_meeting_ = crowded.count() > 0;
    report_.is_orientable = turned.count() == 0 || (crowded.count() == 0 && is_orientable(marks));
    const auto edge = [this](const std::size_t s) { return edge_text(polygons_, s); };
    const auto faces = [this](const std::size_t s) { return faces_text(polygons_, s); };
    add(Defect::DUPLICATE_FACE, duplicates, [&](const std::size_t f) {
      return "face " + face_text(polygons_, f) + " has the same corners as face " + std::to_string(first_face_like(f));
    });
    add_edges(Defect::NON_MANIFOLD_EDGE, crowded, [&](const std::size_t s) {
      return edge(s) + " has " + std::to_string(polygons_.faces_of_edge(s).size()) + " faces (" + faces(s) + ")";
    });
    add_edges(Defect::INCONSISTENT_ORIENTATION, turned, [&](const std::size_t s) {
      const bool is_one_sided = !report_.is_orientable && crowded.count() == 0;
      return edge(s) + " is traversed in the same direction by both its faces (" + faces(s) +
             (is_one_sided ? ") and the surface is one-sided, so that no choice of directions fits" : ")");
    });
    add_edges(Defect::ZERO_LENGTH_EDGE, coincident,
              [&](const std::size_t s) { return edge(s) + " of " + faces(s) + " has zero length, its ends coincide"; });
    count_fans(fans);
    if (all_finite_)
      lengths_ = lengths;
  }
  // Searches the faces at those edges of a bucket that have more than two faces.
  void find_duplicates_in_bucket(const std::size_t begin, const std::size_t end, const std::vector<Edge_mark>& marks,
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
  // itself turned; a one-sided surface connects them. Called only if edges disagree.
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
    add_edges(Defect::OUT_OF_RANGE, shortest, [this](const std::size_t s) {
      std::ostringstream text;
      text << edge_text(polygons_, s) << " (length about " << lengths_.shortest() << ") and "
           << edge_text(polygons_, lengths_.longest_edge()) << " (length about ";
      if (std::isinf(lengths_.longest()))
        text << "2^1024";
      else
        text << lengths_.longest();
      text << ") differ by a factor of about 2^"
           << report_.exponent_of_longest_edge - report_.exponent_of_shortest_edge;
      return text.str();
    });
  }

  // The corners at a vertex that are connected through sides are one fan.
  void count_fans(Disjoint_sets& fans)
  {
    std::vector<Index> number_of_fans(number_of_vertices_, 0);
    Element_collector pinched;
    for (std::size_t f = 0; f < report_.number_of_faces; ++f) {
      const std::size_t begin = polygons_.begin_of_face(f), end = polygons_.begin_of_face(f + 1);
      if (end - begin < 3 || polygons_.vertex(begin) == none_)
        continue;
      for (std::size_t c = begin; c < end; ++c)
        if (fans.find(static_cast<Index>(c)) == c)
          ++number_of_fans[polygons_.vertex(c)];
    }
    for (std::size_t v = 0; v < number_of_vertices_; ++v)
      if (number_of_fans[v] > 1)
        pinched.add(v);
    are_sheets_meeting_ = are_sheets_meeting_ || pinched.count() > 0;
    add(Defect::NON_MANIFOLD_VERTEX, pinched, [&](const std::size_t v) {
      std::string faces;
      std::size_t written = 0;
      for (std::size_t c = 0; c < polygons_.number_of_corners() && written < 2; ++c)
        if (polygons_.vertex(c) == v && fans.find(static_cast<Index>(c)) == c)
          faces +=
            (written++ == 0 ? "one with face " : ", another with face ") + std::to_string(polygons_.face_of_corner(c));
      return "the faces around vertex " + std::to_string(v) + " form " + std::to_string(number_of_fans[v]) +
             " fans that touch only there (" + faces + ")";
    });
  }
  void examine_use()
  {
    Disjoint_sets pieces(number_of_vertices_);
    polygons_.for_each_side(
      [&](const Index s, const Index t) { pieces.unite(polygons_.vertex(s), polygons_.vertex(t)); });
    Element_collector unused, roots;
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      if (!polygons_.is_used(v))
        unused.add(v);
      else if (pieces.find(static_cast<Index>(v)) == v)
        roots.add(v);
    }
    report_.number_of_components = roots.count();
    add(Defect::UNREFERENCED_VERTEX, unused,
        [](const std::size_t v) { return "vertex " + std::to_string(v) + " is not referenced by any face"; });
    if (roots.count() > 1)
      add(Defect::SEVERAL_COMPONENTS, roots,
          [&](std::size_t) { return "the surface has " + std::to_string(roots.count()) + " components"; });
  }

  const std::vector<Coordinates> points_;
  Polygon_sides polygons_;
  const std::size_t number_of_vertices_ = polygons_.number_of_vertices();
  bool all_finite_ = true, has_flat_faces_ = false, are_sheets_meeting_ = false;
  std::vector<Index> border_; // positions of sides without a partner
  Box box_;                   // of the vertices that are used
  int exponent_ = 0;
  Length_range lengths_;
  Surface_report report_;
};

Surface_report examine(Polygon_copies polygons, bool only_gaps)
{
  return Surface_examiner(std::move(polygons)).examine(only_gaps);
}

Surface_report examine_data(Polygon_copies polygons) { return Surface_examiner(std::move(polygons)).examine_data(); }

bool is_connected(const Delta_complex& complex)
{
  const std::size_t n = complex.number_of_faces();
  std::vector<char> is_reached(n, false);
  std::vector<Face_index> reached(n); // in this order
  std::size_t number = 1;
  is_reached[0] = true;
  reached[0] = Face_index(0);
  for (std::size_t i = 0; i < number; ++i) {
    const Halfedge_index h = complex.halfedge(reached[i]);
    for (Halfedge_index side : {h, complex.next(h), complex.prev(h)})
      if (const Face_index f = complex.face(complex.opposite(side)); f.is_valid() && !is_reached[f.idx()]) {
        is_reached[f.idx()] = true;
        reached[number++] = f;
      }
  }
  return number == n;
}

} // namespace internal

std::vector<std::size_t> turned_triangles(const std::vector<std::array<double, 3>>& points,
                                          const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  const internal::Points places(points.begin(), points.end());
  const internal::Surface_gluer gluer(places, triangles);
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (gluer.is_turned(f))
      result.push_back(f);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
