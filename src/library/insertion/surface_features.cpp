// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of surface_features.h: flat vertices and sharp edges.

#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../measures/Face_directions.h"
#include "../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

// The faces around an inner vertex. The spokes are the halfedges that leave it, counterclockwise; face i lies between
// the spokes i and i + 1.
class Flat_star
{
public:
  Flat_star(Delta_complex& complex, const std::vector<std::array<double, 3>>& points, double tolerance = 0)
    : complex_(complex), points_(points), tolerance_(tolerance), widths_(tolerance > 0 ? complex.number_of_faces() : 0)
  {}

  // Removes the vertex if it is flat.
  std::optional<Removed_elements> remove(Vertex_index v)
  {
    if (!complex_.halfedge(v).is_valid() || !find_spokes(v))
      return std::nullopt;
    if (tolerance_ > 0)
      return remove_nearly_flat();
    if (!find_ridges())
      return std::nullopt;
    if (ridges_.empty())
      return angle_is_smallest(0, 0) ? remove_from_plane() : std::nullopt;
    const std::size_t a = ridges_[0], b = ridges_[1];
    const Point p = end(a), q = end(b);
    if (!collinear(p, center_, q) || !collinear_are_strictly_ordered_along_line(p, center_, q) ||
        !angle_is_smallest(a, b) || !angle_is_smallest(b, a))
      return std::nullopt;
    link_spokes();
    flip_away(b, a); // in the plane of the last question
    look_at_face(a);
    flip_away(a, b);
    return unsplit(a);
  }

  bool has_tolerance() const { return tolerance_ > 0; }
  // How far the surface has moved at most.
  double deviation() const { return deviation_; }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;

  Point point(Vertex_index v) const
  {
    const auto& p = points_[v.idx()];
    return {p[0], p[1], p[2]};
  }
  std::size_t number_of_spokes() const { return spokes_.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == spokes_.size() ? 0 : i + 1; }
  const Point& end(std::size_t i) const { return ends_[i]; }

  // Returns whether the vertex is no border vertex and no face beside it has zero area.
  bool find_spokes(Vertex_index v)
  {
    spokes_.clear();
    ends_.clear();
    center_ = point(v);
    const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    Halfedge_index h = first;
    do {
      if (complex_.is_border(h))
        return false;
      spokes_.push_back(h);
      ends_.push_back(point(complex_.target(h)));
      h = complex_.next_around_source(h);
    } while (h != first);
    return true;
  }

  // The spokes between faces in different planes, or folded onto each other. Returns whether there are none or two.
  bool find_ridges()
  {
    ridges_.clear();
    for (std::size_t i = 0, before = number_of_spokes() - 1; i < number_of_spokes(); before = i++) {
      const std::size_t after = next(i);
      if (collinear(center_, end(i), end(after)))
        return false;
      const bool is_ridge = !coplanar(center_, end(i), end(before), end(after)) ||
                            coplanar_orientation(center_, end(i), end(before), end(after)) != NEGATIVE;
      if (is_ridge)
        ridges_.push_back(i);
      if (ridges_.size() > 2)
        return false;
    }
    return ridges_.size() != 1;
  }

  // Projects along a coordinate axis that is not parallel to the plane of face i, so that the face is counterclockwise.
  void look_at_face(std::size_t i)
  {
    for (axis_ = 0; axis_ < 3; ++axis_) {
      turn_ = POSITIVE;
      turn_ = orientation(center_, end(i), end(next(i)));
      if (turn_ != ZERO)
        return;
    }
  }
  Orientation orientation(const Point& p, const Point& q, const Point& r) const
  {
    const auto shadow = [this](const Point& p) { return Kernel::Point_2(p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]); };
    return CGAL::orientation(shadow(p), shadow(q), shadow(r)) * turn_;
  }

  // Whether the angle from one spoke to another, all in one plane, is no full turn larger than it has to be: one face
  // alone has the direction of the first spoke, on its right side or inside. Looks at the plane.
  bool angle_is_smallest(std::size_t from, std::size_t to)
  {
    look_at_face(from);
    return is_covered_once(from, to);
  }
  bool is_covered_once(std::size_t from, std::size_t to) const
  {
    std::size_t count = 0, i = from;
    do {
      const std::size_t j = next(i);
      if (orientation(center_, end(i), end(from)) != NEGATIVE && orientation(center_, end(from), end(j)) == POSITIVE)
        ++count;
      i = j;
    } while (i != to);
    return count == 1;
  }

  void link_spokes()
  {
    number_left_ = number_of_spokes();
    left_.resize(number_left_);
    right_.resize(number_left_);
    is_gone_.assign(number_left_, false);
    for (std::size_t i = 0; i < number_left_; ++i) {
      left_[i] = next(i);
      right_[next(i)] = i;
    }
  }

  // Flips spokes away that are no ridges, from the first to before the last, all in the plane that is looked at. At the
  // end of a spoke, the corner of the polygon around the vertex is cut off if it is convex and the vertex lies beyond
  // the cut.
  void flip_away(std::size_t first, std::size_t last)
  {
    candidates_.clear();
    std::size_t i = first;
    do {
      candidates_.push_back(i);
      i = next(i);
    } while (i != last);
    while (number_left_ > 3 && !candidates_.empty()) {
      i = candidates_.back();
      candidates_.pop_back();
      const std::size_t right = right_[i], left = left_[i];
      if (is_gone_[i] || is_ridge(i) || orientation(end(right), end(i), end(left)) != POSITIVE ||
          orientation(center_, end(right), end(left)) != POSITIVE || is_thin(right, i, left) ||
          (is_ridge(right) && is_ridge(left)))
        continue;
      complex_.flip(complex_.edge(spokes_[i]));
      if (tolerance_ > 0)
        flips_.push_back(complex_.edge(spokes_[i]));
      is_gone_[i] = true;
      --number_left_;
      left_[right] = left;
      right_[left] = right;
      candidates_.push_back(right);
      candidates_.push_back(left);
    }
  }
  // With a tolerance, points that are nearly in line are no corner: a triangle of them would stand between a vertex and
  // its removal. A larger tolerance does not make every small triangle thin.
  bool is_thin(std::size_t right, std::size_t i, std::size_t left) const
  {
    constexpr double part_of_base = 0x1p-6;
    const Vector base = difference(end(left), end(right));
    const double length = norm(base);
    return tolerance_ > 0 && !(norm(cross_product(difference(end(i), end(right)), base)) >
                               (std::min)(tolerance_, part_of_base * length) * length);
  }
  bool is_ridge(std::size_t i) const { return std::find(ridges_.begin(), ridges_.end(), i) != ridges_.end(); }

  // Of the corners of the polygon, one can be cut off while there are more than four, or four of which no two are in
  // line with the vertex: two ears of a polygon do not overlap, and the vertex can lie in one of them only, or on the
  // cut.
  std::optional<Removed_elements> remove_from_plane()
  {
    link_spokes();
    flip_away(0, 0);
    std::size_t i = 0;
    while (is_gone_[i])
      ++i;
    if (number_left_ == 3)
      return complex_.unsplit_face(complex_.source(spokes_[i]));
    for (std::size_t k : {i, left_[i]})
      if (number_left_ == 4 && orientation(center_, end(k), end(left_[left_[k]])) == ZERO)
        return unsplit(k);
    return std::nullopt;
  }

  using Vector = std::array<double, 3>;
  static Vector difference(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
  static double norm(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

  std::optional<Removed_elements> remove_nearly_flat()
  {
    double before = 0;
    faces_.clear();
    flips_.clear();
    for (Halfedge_index h : spokes_) {
      faces_.push_back(complex_.face(h));
      before = (std::max)(before, widths_[faces_.back().idx()]);
    }
    ridges_.clear();
    double width = before + width_of(0, 0);
    const auto result = width <= tolerance_ ? remove_from_plane() : remove_from_ridge(before, width);
    if (!result) {
      for (; !flips_.empty(); flips_.pop_back())
        complex_.flip_back(flips_.back());
      return result;
    }
    deviation_ = (std::max)(deviation_, width);
    for (Face_index f : faces_)
      widths_[f.idx()] = width;
    remove_entries(widths_, result->faces);
    return result;
  }
  // The width of the slab that holds the faces from one spoke to another, or infinity if they are not like a part of a
  // plane. Looks at the plane.
  double width_of(std::size_t from, std::size_t to)
  {
    constexpr double infinite = (std::numeric_limits<double>::infinity)();
    Vector normal{};
    for (std::size_t i = from;;) {
      const Vector part = cross_product(difference(end(i), center_), difference(end(next(i)), center_));
      for (std::size_t axis = 0; axis < 3; ++axis)
        normal[axis] += part[axis];
      if ((i = next(i)) == to)
        break;
    }
    const double length = norm(normal);
    if (!(length > 0 && length < infinite))
      return infinite;
    axis_ = 0;
    for (int axis : {1, 2})
      if (std::abs(normal[std::size_t(axis)]) > std::abs(normal[std::size_t(axis_)]))
        axis_ = axis;
    turn_ = normal[std::size_t(axis_)] > 0 ? POSITIVE : NEGATIVE;
    double lowest = 0, highest = 0;
    for (std::size_t i = from;;) {
      const std::size_t j = next(i);
      if (orientation(center_, end(i), end(j)) != POSITIVE)
        return infinite;
      for (std::size_t k : {i, j}) {
        const double height = scalar_product(difference(end(k), center_), normal) / length;
        if (!std::isfinite(height))
          return infinite;
        lowest = (std::min)(lowest, height);
        highest = (std::max)(highest, height);
      }
      if ((i = j) == to)
        break;
    }
    return is_covered_once(from, to) ? highest - lowest : infinite;
  }
  // How far the vertex is from the line between the ends of two spokes, or infinity if it is not between them.
  double distance_from_line(std::size_t a, std::size_t b) const
  {
    const Vector p = difference(end(a), center_), q = difference(end(b), center_);
    if (!(scalar_product(p, q) < 0))
      return (std::numeric_limits<double>::infinity)();
    return norm(cross_product(p, q)) / norm(difference(end(b), end(a)));
  }
  std::optional<Removed_elements> remove_from_ridge(double before, double& width)
  {
    for (std::size_t a = 0; a < number_of_spokes(); ++a)
      for (std::size_t b = a + 1; b < number_of_spokes(); ++b) {
        const double distance = before + distance_from_line(a, b);
        if (!(distance <= tolerance_))
          continue;
        const double left = width_of(a, b), right = width_of(b, a);
        width = distance + (std::max)(left, right);
        if (!(width <= tolerance_))
          continue;
        ridges_ = {a, b};
        link_spokes();
        flip_away(b, a); // in the plane of the last question
        const bool is_free = has_one_spoke_beyond(b, a);
        width_of(a, b); // looks at the other plane
        flip_away(a, b);
        return is_free && has_one_spoke_beyond(a, b) ? std::optional<Removed_elements>(unsplit(a)) : std::nullopt;
      }
    return std::nullopt;
  }
  // Whether one spoke is left between two, and its end is on the same side of the line between theirs.
  bool has_one_spoke_beyond(std::size_t from, std::size_t to) const
  {
    const std::size_t i = left_[from];
    return left_[i] == to && orientation(end(from), end(i), end(to)) == POSITIVE && !is_thin(from, i, to);
  }

  // Removes the vertex from the straight line that ends with the spoke i.
  Removed_elements unsplit(std::size_t i) { return complex_.unsplit_edge(complex_.opposite(spokes_[i])); }

  Delta_complex& complex_;
  const std::vector<std::array<double, 3>>& points_;
  Point center_;
  std::vector<Halfedge_index> spokes_;
  std::vector<Point> ends_;
  std::vector<std::size_t> ridges_, left_, right_, candidates_;
  std::vector<bool> is_gone_;
  std::size_t number_left_ = 0;
  const double tolerance_;
  std::vector<double> widths_; // of the slab around each face that contains what the face replaced, with a tolerance
  double deviation_ = 0;
  std::vector<Face_index> faces_; // of the star
  std::vector<Edge_index> flips_;
  int axis_ = 0; // of the projection
  Sign turn_ = POSITIVE;
};

// \param result the previous descriptors of the vertices
inline void remove_vertices_of(Flat_star& star, std::vector<std::array<double, 3>>& points,
                               std::vector<Vertex_index>& result, const Progress_function& progress)
{
  const Loop_progress loop(progress, "removing flat vertices", 0, 1, result.size());
  // The last vertex, which moves, has been looked at.
  const auto look_at = [&](std::size_t v) {
    const auto removed = star.remove(Vertex_index(std::uint32_t(v)));
    if (removed) {
      remove_entries(points, removed->vertices);
      remove_entries(result, removed->vertices);
    }
    return removed.has_value();
  };
  const std::size_t number = result.size();
  for (std::size_t v = number; v-- > 0;) {
    loop.at(number - 1 - v);
    look_at(v);
  }
  // With a tolerance, the removal of one vertex can make way for another one.
  for (bool goes_on = star.has_tolerance() && result.size() < number; goes_on;) {
    report_progress(progress, 1, "removing flat vertices");
    goes_on = false;
    for (std::size_t v = result.size(); v-- > 0;)
      goes_on = look_at(v) || goes_on;
  }
}

inline void drop_short_chains(const Delta_complex& complex, const Face_directions& directions, double minimum_length,
                              std::vector<bool>& is_sharp)
{
  Disjoint_sets chains(complex.number_of_vertices());
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()])
      chains.unite(complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx());
  std::vector<double> lengths(complex.number_of_vertices());
  const auto chain = [&](Edge_index e) { return chains.find(complex.source(complex.halfedge(e)).idx()); };
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()])
      lengths[chain(e)] += directions.length(complex.halfedge(e));
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()] && lengths[chain(e)] < minimum_length)
      is_sharp[e.idx()] = false;
}

} // namespace internal

std::vector<Vertex_index> internal::remove_flat_vertices(Delta_complex& complex,
                                                         std::vector<std::array<double, 3>>& points,
                                                         const Progress_function& progress)
{
  const internal::Standard_arithmetic arithmetic;
  internal::Flat_star star(complex, points);
  std::vector<Vertex_index> result(complex.vertices().begin(), complex.vertices().end());
  internal::remove_vertices_of(star, points, result, progress);
  return result;
}

// First those that need no tolerance, so that none of them stays for another one.
Flat_vertex_removal internal::remove_nearly_flat_vertices(Delta_complex& complex,
                                                          std::vector<std::array<double, 3>>& points, double tolerance,
                                                          const Progress_function& progress)
{
  Flat_vertex_removal result;
  result.vertices = internal::remove_flat_vertices(complex, points, part_of_progress(progress, 0, 0.5));
  if (!(tolerance > 0))
    return result;
  const internal::Standard_arithmetic arithmetic;
  internal::Flat_star star(complex, points, tolerance);
  internal::remove_vertices_of(star, points, result.vertices, part_of_progress(progress, 0.5, 1));
  result.deviation = star.deviation();
  return result;
}

double coordinate_spacing(const std::vector<std::array<double, 3>>& points)
{
  double largest = 0;
  bool are_floats = true;
  for (const auto& p : points)
    for (double x : p) {
      largest = (std::max)(largest, std::abs(x));
      are_floats = are_floats && std::abs(x) <= double((std::numeric_limits<float>::max)()) && double(float(x)) == x;
    }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0 ? std::ldexp(1., exponent - (are_floats ? 24 : 53)) : 0;
}

std::vector<bool> sharp_edges(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                              double degrees, double minimum_size)
{
  const internal::Standard_arithmetic arithmetic;
  internal::Face_directions directions(complex, points, (std::max)(minimum_size, 4 * coordinate_spacing(points)));
  std::vector<bool> result(complex.number_of_edges());
  for (Edge_index e : complex.edges()) {
    if (complex.is_border(e))
      continue;
    const Halfedge_index h = complex.halfedge(e);
    const auto &m = directions(complex.face(h)), &n = directions(complex.face(complex.opposite(h)));
    const auto across = internal::cross_product(m, n);
    result[e.idx()] = std::atan2(std::hypot(across[0], across[1], across[2]), internal::scalar_product(m, n)) >
                      degrees * (CGAL_PI / 180);
  }
  internal::drop_short_chains(complex, directions, minimum_size, result);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
