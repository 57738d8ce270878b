// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The order in which vertices are removed, and the changes by a removal.

#include "Simplifier.h"
#include "Fan.h"
#include "Fan_proof.h"

#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr std::uint32_t no_vertex = std::uint32_t(-1);

// Rounding changes lengths by up to this fraction.
constexpr double least_change = 1e-12;
constexpr double largest_change = 1e100; // its square is finite
// The triangulation of a hole takes quadratic time.
constexpr std::size_t largest_degree = 1000;

enum class Obstacle {
  NONE,
  REQUEST,
  CORNER,
  GLUING,
  BOUND,
  NO_FACE
};

// The edges from a vertex, counterclockwise, and the one or two fans of faces between them.
struct Vertex_star
{
  struct Part
  {
    std::size_t first = 0; // its first spoke
    Fan fan;
    Fan_array<double> factors; // by which the spokes become longer
    Fan_triangulation holes;
    Fan_array<Squared_change> changes; // of the new triangles
    Fan_array<Simplification_map::Triangle> old_triangles;
    Fan_array<std::uint32_t> new_numbers;
  };

  Fan_array<Halfedge_index> spokes;
  std::size_t number_of_parts = 1;
  std::array<Part, 2> parts;
  double line = 0; // that replaces two border edges, or two constrained ones

  Halfedge_index spoke(const Part& part, std::size_t j) const { return spokes[(part.first + j) % spokes.size()]; }
};

class Simplifier
{
public:
  Simplifier(const Delta_complex& complex, std::vector<double> lengths, const Simplification_options& options)
    : options_(options), complex_(complex), lengths_(std::move(lengths)), is_constrained_(options.is_constrained),
      largest_factor_(1 + (std::min)((std::max)(options.maximum_change, least_change), largest_change)),
      limit_(largest_factor_ * largest_factor_ * (1 - 1e-15)), stamps_(complex.number_of_vertices(), 0)
  {
    normalize();
    map_ = Simplification_map(complex_, lengths_);
    for (Vertex_index v : complex_.vertices()) {
      original_.push_back(v.idx());
      current_.push_back(v.idx());
      number_of_vertices_ += complex_.halfedge(v).is_valid();
    }
  }

  Simplification operator()()
  {
    for (std::size_t v = 0; v < original_.size(); ++v)
      enqueue(std::uint32_t(v));
    const std::size_t at_first = number_of_vertices_;
    std::size_t removed = 0;
    while (!queue_.empty() && number_of_vertices_ > options_.number_of_vertices) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.stamp != stamps_[entry.vertex] || current_[entry.vertex] == no_vertex)
        continue;
      if (!remove(Vertex_index(current_[entry.vertex])))
        continue;
      ++removed;
      if (removed % 256 == 0)
        report_progress(options_.progress, double(removed) / double(at_first), "the simplification");
    }
    return result();
  }

private:
  struct Face
  {
    double four_areas;
    Squared_change change;
    std::uint32_t number; // in the map
    bool is_thin = false;
  };

  // -------------------------------------------------------------------------------- at first

  // A power of two makes the longest edge about 1. From now on a face is the triangle with these doubles as lengths,
  // and knows how that differs from what was given. Thin faces, which doubles cannot describe, stay what they are.
  void normalize()
  {
    const double longest = lengths_.empty() ? 1 : *std::max_element(lengths_.begin(), lengths_.end());
    exponent_ = -std::ilogb(longest);
    for (std::size_t e = 0; e < lengths_.size(); ++e) {
      const double scaled = std::ldexp(lengths_[e], exponent_);
      constexpr double least = (std::numeric_limits<double>::min)();
      if (lengths_[e] < least || scaled < least)
        throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, e, 1,
                                    "the length of edge " + std::to_string(e) +
                                      " is below the range of normal doubles: scale the surface");
      lengths_[e] = scaled;
    }
    const double most = (std::min)(std::sqrt(std::sqrt(limit_)), 1.01);
    for (Face_index f : complex_.faces()) {
      const std::array<double, 3> lengths = sides(f);
      const Squared_change change = change_by_rounding(lengths);
      const bool is_thin = !(change.up <= most);
      faces_.push_back({four_areas(lengths), is_thin ? Squared_change() : change, f.idx(), is_thin});
    }
  }

  double length(Halfedge_index h) const { return lengths_[complex_.edge(h).idx()]; }
  std::array<double, 3> sides(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    return {length(h), length(complex_.next(h)), length(complex_.prev(h))};
  }
  static double four_areas(const std::array<double, 3>& sides)
  {
    return std::sqrt((std::max)(0., squared_four_areas_from_lengths(sides[0], sides[1], sides[2])));
  }

  // -------------------------------------------------------------------------------- the queue

  struct Entry
  {
    float change; // so that numbers that differ by rounding are equal
    float size;
    std::uint32_t vertex, stamp;

    bool operator<(const Entry& other) const
    {
      return std::tie(other.change, other.size, other.vertex) < std::tie(change, size, vertex);
    }
  };

  // Enters a vertex under its original number.
  void enqueue(std::uint32_t vertex)
  {
    ++stamps_[vertex];
    double change = 0;
    if (examine(Vertex_index(current_[vertex]), change) != Obstacle::NONE)
      return;
    double size = 0;
    for (Halfedge_index h : star_.spokes)
      size += length(h);
    queue_.push(
      {float(change - 1 < 1e-9 ? 0 : change - 1), float(size / double(star_.spokes.size())), vertex, stamps_[vertex]});
  }

  // Lays the faces around a vertex flat, and finds the squared change that results.
  Obstacle examine(Vertex_index v, double& change)
  {
    const Obstacle obstacle = find_star(v);
    if (obstacle != Obstacle::NONE)
      return obstacle;
    Vertex_star::Part &one = star_.parts[0], &two = star_.parts[1];
    if (!flatten(one.fan, largest_factor_, one.factors))
      return Obstacle::BOUND;
    if (star_.number_of_parts == 2) {
      if (!flatten(two.fan, largest_factor_, two.factors))
        return Obstacle::BOUND;
      const double ends = std::sqrt(one.factors.front() * two.factors.front());
      if (!flatten_between_ends(one.fan, ends, largest_factor_, one.factors) ||
          !flatten_between_ends(two.fan, ends, largest_factor_, two.factors))
        return Obstacle::BOUND;
    }
    change = largest_squared_change(one.fan, one.factors);
    if (star_.number_of_parts == 2)
      change = (std::max)(change, largest_squared_change(two.fan, two.factors));
    if (!one.fan.is_closed)
      star_.line = one.factors.front() * (one.fan.spokes.front() + one.fan.spokes.back());
    return change <= limit_ ? Obstacle::NONE : Obstacle::BOUND;
  }

  Obstacle find_star(Vertex_index v)
  {
    if (!complex_.halfedge(v).is_valid())
      return Obstacle::NO_FACE;
    if (options_.is_kept[original_[v.idx()]])
      return Obstacle::REQUEST;
    const bool is_on_border = complex_.is_border(complex_.halfedge(v));
    star_.spokes.clear();
    std::size_t line[2] = {0, 0}, number_of_lines = 0;
    Obstacle obstacle = Obstacle::NONE;
    const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    for (Halfedge_index h = first;;) {
      if (complex_.target(h) == v || star_.spokes.size() == largest_degree)
        return Obstacle::GLUING; // early: a vertex of high degree is examined after each removal beside it
      if (!complex_.is_border(h) && faces_[complex_.face(h).idx()].is_thin)
        obstacle = Obstacle::BOUND;
      if (is_constrained_[complex_.edge(h).idx()] && !complex_.is_border(complex_.edge(h)) && ++number_of_lines <= 2)
        line[number_of_lines - 1] = star_.spokes.size();
      star_.spokes.push_back(h);
      if (complex_.is_border(h) || (h = complex_.next_around_source(h)) == first)
        break;
    }
    if (obstacle != Obstacle::NONE)
      return obstacle;
    if (number_of_lines != 0 && (number_of_lines != 2 || is_on_border))
      return Obstacle::REQUEST;
    const std::size_t n = star_.spokes.size();
    if (n < 3)
      return is_on_border ? Obstacle::CORNER : Obstacle::GLUING;
    star_.number_of_parts = number_of_lines == 0 ? 1 : 2;
    if (number_of_lines == 2) {
      if (line[1] - line[0] < 2 || n + line[0] - line[1] < 2)
        return Obstacle::CORNER;
      add_fan(0, line[0], line[1] - line[0] + 1, false);
      add_fan(1, line[1], n + line[0] - line[1] + 1, false);
    } else {
      add_fan(0, 0, n, !is_on_border);
    }
    const bool is_open = !star_.parts[0].fan.is_closed;
    const Vertex_star::Part& one = star_.parts[0];
    if (is_open && complex_.target(star_.spoke(one, 0)) == complex_.target(star_.spoke(one, one.fan.size() - 1)))
      return Obstacle::GLUING;
    return Obstacle::NONE;
  }

  void add_fan(std::size_t i, std::size_t first, std::size_t size, bool is_closed)
  {
    Vertex_star::Part& part = star_.parts[i];
    part.first = first;
    Fan& fan = part.fan;
    fan.clear();
    fan.is_closed = is_closed;
    for (std::size_t j = 0; j < size; ++j) {
      const Halfedge_index h = star_.spoke(part, j);
      fan.spokes.push_back(length(h));
      if (j + 1 == size && !is_closed)
        break;
      fan.link.push_back(length(complex_.next(h)));
      fan.changes.push_back(faces_[complex_.face(h).idx()].change);
    }
  }

  // -------------------------------------------------------------------------------- removal

  // Removes a vertex if the bound can be proven.
  bool remove(Vertex_index v)
  {
    double change = 0;
    if (examine(v, change) != Obstacle::NONE)
      return false;
    for (std::size_t i = 0; i < star_.number_of_parts; ++i) {
      Vertex_star::Part& part = star_.parts[i];
      if (!triangulate(part.fan, part.factors, star_.line, part.holes) ||
          !prove_removal(part.fan, part.holes, limit_, part.changes))
        return false;
    }
    touched_.clear();
    for (Halfedge_index h : star_.spokes)
      touched_.push_back(original_[complex_.target(h).idx()]);
    for (std::size_t i = 0; i < star_.number_of_parts; ++i)
      note_old_triangles(star_.parts[i]);
    for (std::size_t i = 0; i < star_.number_of_parts; ++i)
      cut_ears(star_.parts[i]);
    take_out(v);
    --number_of_vertices_;
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (std::uint32_t vertex : touched_)
      enqueue(vertex);
    return true;
  }

  // The corners of a face by the numbers of the points of a step, from `halfedge(f)` on.
  Simplification_map::Triangle triangle(Halfedge_index h, std::uint32_t source, std::uint32_t target,
                                        std::uint32_t third) const
  {
    const Face_index f = complex_.face(h);
    std::array<std::uint32_t, 3> corners{source, target, third};
    if (complex_.halfedge(f) == complex_.next(h))
      corners = {target, third, source};
    else if (complex_.halfedge(f) == complex_.prev(h))
      corners = {third, source, target};
    return {faces_[f.idx()].number, corners};
  }

  void note_old_triangles(Vertex_star::Part& part) const
  {
    part.old_triangles.clear();
    const Fan& fan = part.fan;
    for (std::size_t j = 0; j < fan.link.size(); ++j)
      part.old_triangles.push_back(
        triangle(star_.spoke(part, j), std::uint32_t(fan.size()), std::uint32_t(j), std::uint32_t(fan.after(j))));
  }

  // Flips all spokes but those of the last triangle.
  void cut_ears(Vertex_star::Part& part)
  {
    part.new_numbers.clear();
    for (std::size_t i = 0; i + 1 < part.holes.ears.size(); ++i) {
      const Ear& ear = part.holes.ears[i];
      const Halfedge_index spoke = star_.spoke(part, ear.tip);
      complex_.flip(complex_.edge(spoke)); // leads from `before` to `after` now
      lengths_[complex_.edge(spoke).idx()] = ear.after_before;
      part.new_numbers.push_back(
        set_face(complex_.opposite(spoke), {ear.after_before, ear.before_tip, ear.tip_after}, part.changes[i]));
    }
  }

  // A new face, which begins with h. Returns its number.
  std::uint32_t set_face(Halfedge_index h, const std::array<double, 3>& sides, const Squared_change& change)
  {
    const Face_index f = complex_.face(h);
    complex_.set_halfedge(f, h);
    faces_[f.idx()] = {four_areas(sides), change, map_.add_triangle(sides)};
    return faces_[f.idx()].number;
  }

  // Removes the vertex from the last triangle of each part.
  void take_out(Vertex_index v)
  {
    Halfedge_index cores[2]; // from `before` to `tip`
    for (std::size_t i = 0; i < star_.number_of_parts; ++i)
      cores[i] = complex_.next(star_.spoke(star_.parts[i], star_.parts[i].holes.ears.back().before));
    const bool is_closed = star_.parts[0].fan.is_closed;
    const Halfedge_index along = complex_.opposite(star_.spokes[star_.parts[0].first]);
    const Halfedge_index joined = complex_.is_border(complex_.halfedge(v)) ? complex_.halfedge(v) : along;
    const Edge_index line = complex_.edge(joined);
    const Removed_elements removed = is_closed ? complex_.unsplit_face(v) : complex_.unsplit_edge(joined);
    remove_entries(lengths_, removed.edges);
    remove_entries(is_constrained_, removed.edges);
    remove_entries(faces_, removed.faces);
    const std::uint32_t moved = original_.back();
    current_[original_[v.idx()]] = no_vertex;
    remove_entries(original_, removed.vertices);
    if (v.idx() < original_.size())
      current_[moved] = v.idx();
    if (!is_closed)
      lengths_[removed.edge_after(line).idx()] = star_.line;
    for (std::size_t i = 0; i < star_.number_of_parts; ++i) {
      Vertex_star::Part& part = star_.parts[i];
      const Ear& core = part.holes.ears.back();
      const Halfedge_index h(2 * removed.edge_after(complex_.edge(cores[i])).idx() + (cores[i].idx() & 1));
      part.new_numbers.push_back(
        set_face(h, {core.before_tip, core.tip_after, core.after_before}, part.changes.back()));
      add_step(part);
    }
  }

  // Each new triangle lies beside one before.
  void add_step(const Vertex_star::Part& part)
  {
    for (const Simplification_map::Triangle& t : part.old_triangles)
      map_.add_to_step(t);
    const Ear& core = part.holes.ears.back();
    map_.add_to_step({part.new_numbers.back(), {core.before, core.tip, core.after}});
    for (std::size_t i = part.holes.ears.size() - 1; i-- > 0;) {
      const Ear& ear = part.holes.ears[i];
      map_.add_to_step({part.new_numbers[i], {ear.after, ear.before, ear.tip}});
    }
    map_.add_step(std::uint32_t(part.old_triangles.size()), std::uint32_t(part.fan.size() + 1), part.holes.place);
  }

  // -------------------------------------------------------------------------------- at the end

  Simplification result()
  {
    Simplification result;
    for (Vertex_index v : complex_.vertices())
      count(v, result.reasons);
    std::vector<bool> is_exact(lengths_.size());
    for (Face_index f : complex_.faces())
      if (faces_[f.idx()].is_thin) {
        result.thin_faces.push_back({f, Face_index(faces_[f.idx()].number)});
        for_each_side(f, [&](Edge_index e) { is_exact[e.idx()] = true; });
      }
    std::vector<std::uint32_t> numbers;
    for (Face_index f : complex_.faces()) {
      const Face& face = faces_[f.idx()];
      bool has_exact_side = false;
      for_each_side(f, [&](Edge_index e) { has_exact_side = has_exact_side || is_exact[e.idx()]; });
      const Squared_change change =
        has_exact_side && !face.is_thin ? product(face.change, change_by_rounding(sides(f))) : face.change;
      // The root is within half a unit in the last place.
      const auto root = [](double x, double away) { return x == 1 ? 1 : std::nextafter(std::sqrt(x), away); };
      result.changes.push_back({root(change.down, 0.), root(change.up, std::numeric_limits<double>::infinity())});
      numbers.push_back(face.number);
    }
    map_.finish(complex_, std::move(numbers));
    for (double& l : lengths_)
      l = std::ldexp(l, -exponent_);
    for (std::uint32_t v : original_)
      result.kept.push_back(Vertex_index(v));
    result.lengths = std::move(lengths_);
    result.is_constrained = std::move(is_constrained_);
    result.map = std::move(map_);
    return result;
  }

  template <class F>
  void for_each_side(Face_index f, const F& visit) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
      visit(complex_.edge(side));
  }

  void count(Vertex_index v, Kept_vertices& reasons)
  {
    double change = 0;
    switch (examine(v, change)) {
    case Obstacle::NONE:
      ++(number_of_vertices_ > options_.number_of_vertices ? reasons.by_bound : reasons.by_number);
      break;
    case Obstacle::REQUEST:
      ++reasons.by_request;
      break;
    case Obstacle::CORNER:
      ++reasons.as_corners;
      break;
    case Obstacle::GLUING:
      ++reasons.for_gluing;
      break;
    case Obstacle::BOUND:
      ++reasons.by_bound;
      break;
    case Obstacle::NO_FACE:
      ++reasons.isolated;
      break;
    }
  }

  const Simplification_options& options_;
  Delta_complex complex_;
  std::vector<double> lengths_; // times a power of two
  std::vector<bool> is_constrained_;
  double largest_factor_, limit_; // the latter for squared changes
  int exponent_ = 0;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> original_, current_; // the numbers of vertices at first and now
  std::vector<std::uint32_t> stamps_;             // an entry with another stamp is out of date
  std::size_t number_of_vertices_ = 0;
  std::priority_queue<Entry> queue_;
  Simplification_map map_;
  Vertex_star star_;
  std::vector<std::uint32_t> touched_; // vertices whose faces were changed
};

} // namespace

Simplification simplify(const Delta_complex& complex, std::vector<double> lengths,
                        const Simplification_options& options)
{
  return Simplifier(complex, std::move(lengths), options)();
}

} // namespace CGAL::Intrinsic_triangulations::internal
