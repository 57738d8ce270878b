// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Triple_overlay.h.

#include "Triple_overlay.h"
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// What is at the fraction t of a line with homogeneous weights at its ends, in inhomogeneous coordinates.
double projective(double t, double weight_from, double weight_to)
{
  const double sum = (1 - t) * weight_from + t * weight_to;
  return sum > 0 ? t * weight_to / sum : t;
}

constexpr double same_place = 0x1p-44; // on an edge of length 1

double fraction_of(double x, double from, double to)
{
  return to > from ? (std::min)(1., (std::max)(0., (x - from) / (to - from))) : 0.5;
}

} // namespace

Triple_overlay::Triple_overlay(const Common_subdivision& subdivision, const Delta_complex& ideal,
                               const Overlay& ideal_overlay, const std::vector<double>& lengths,
                               const std::vector<double>& u, const Progress_function& progress)
  : subdivision_(subdivision), intrinsic_(subdivision.intrinsic()), ideal_(ideal), ideal_overlay_(ideal_overlay),
    lengths_(lengths), ideal_crossings_(ideal_overlay.number_of_crossings()), on_edges_(intrinsic_.number_of_edges())
{
  const Overlay& overlay = subdivision.overlay();
  const double middle =
    u.empty() ? 0 : (*std::max_element(u.begin(), u.end()) + *std::min_element(u.begin(), u.end())) / 2;
  for (double x : u)
    weights_.push_back(std::exp(middle - x));
  for (Overlay::Vertex v : overlay.vertices()) {
    const Delta_complex& input = subdivision.input();
    if (overlay.is_crossing(v)) {
      const double t = subdivision.positions().on_input_edge(v);
      nodes_.push_back({input.halfedge(overlay.input_edge(v)), {1 - t, t, 0}});
    } else if (overlay.is_inserted(v)) {
      nodes_.push_back(subdivision.positions().location(v));
    } else {
      const Halfedge_index h = input.halfedge(overlay.original_vertex(v));
      nodes_.push_back({h.is_valid() ? input.opposite(h) : h, {1, 0, 0}});
    }
  }
  first_ideal_node_ = std::uint32_t(nodes_.size());
  nodes_.resize(nodes_.size() + ideal_overlay.number_of_crossings());
  index_on_edge_.resize(nodes_.size());
  for (Edge_index e : ideal.edges()) {
    if (e.idx() % 1024 == 0)
      report_progress(progress, 0, "the overlay of three triangulations");
    place_ideal_crossings(e);
  }
  for (Edge_index e : intrinsic_.edges())
    merge(e);
  divide_faces(progress);
}

// λ-lengths from both ends of an edge of C to the ends of the edges of B that it crosses: by Ptolemy's formula from each to
// the next, so nothing cancels. With s and t the ends, j to the left and i to the right,
//   λ_jt λ_js X_i + λ_it λ_is X_j  and  (λ_ij / λ_st) (λ_it λ_jt X_s + λ_is λ_js X_t)
// are the same point.
void Triple_overlay::place_ideal_crossings(Edge_index e)
{
  const auto crossings = ideal_overlay_.intrinsic_crossings(e);
  if (crossings.empty())
    return;
  const auto length = [this](Halfedge_index h) { return lengths_[intrinsic_.edge(h).idx()]; };
  struct Gate
  {
    Halfedge_index halfedge; // from right to left: the face before it is its own
    double left_s, right_s, left_t, right_t;
  };
  std::vector<Gate> gates;
  for (Overlay::Vertex x : crossings)
    gates.push_back({ideal_overlay_.crossing_input_halfedge(x), 0, 0, 0, 0});
  const Halfedge_index first = gates.front().halfedge, last = intrinsic_.opposite(gates.back().halfedge);
  gates.front().left_s = length(intrinsic_.next(first));
  gates.front().right_s = length(intrinsic_.prev(first));
  gates.back().right_t = length(intrinsic_.next(last));
  gates.back().left_t = length(intrinsic_.prev(last));
  const auto leaves_at_right = [&](std::size_t k) { // whether gate k and the next one share the right end
    return gates[k + 1].halfedge == intrinsic_.next(intrinsic_.opposite(gates[k].halfedge));
  };
  // Across the diagonal d, from the sides a and b beside the far end.
  const auto far = [&](double to_a, double a, double to_b, double b, double d) { return (to_a * b + to_b * a) / d; };
  for (std::size_t k = 0; k + 1 < gates.size(); ++k) {
    const Halfedge_index g = gates[k].halfedge, front = intrinsic_.opposite(g);
    const double apex =
      far(gates[k].left_s, length(intrinsic_.prev(front)), gates[k].right_s, length(intrinsic_.next(front)), length(g));
    const bool right = leaves_at_right(k);
    gates[k + 1].left_s = right ? apex : gates[k].left_s;
    gates[k + 1].right_s = right ? gates[k].right_s : apex;
  }
  for (std::size_t k = gates.size() - 1; k > 0; --k) {
    const Halfedge_index g = gates[k].halfedge; // its face is between the gates
    const double apex =
      far(gates[k].right_t, length(intrinsic_.prev(g)), gates[k].left_t, length(intrinsic_.next(g)), length(g));
    const bool right = leaves_at_right(k - 1);
    gates[k - 1].left_t = right ? apex : gates[k].left_t;
    gates[k - 1].right_t = right ? gates[k].right_t : apex;
  }
  const Halfedge_index front = intrinsic_.opposite(gates.back().halfedge);
  const double whole = far(gates.back().left_s, length(intrinsic_.prev(front)), gates.back().right_s,
                           length(intrinsic_.next(front)), length(front));
  const Halfedge_index along = ideal_.halfedge(e);
  const double weight_s = weights_[ideal_.source(along).idx()], weight_t = weights_[ideal_.target(along).idx()];
  std::size_t k = 0;
  for (Overlay::Vertex x : crossings) {
    const Gate& g = gates[k++];
    const double at_i = g.left_t * g.left_s, at_j = g.right_t * g.right_s;
    const double at_s = g.right_t * g.left_t * weight_s, at_t = g.right_s * g.left_s * weight_t;
    const double from_right = at_j / (at_i + at_j);
    Ideal_crossing& crossing = ideal_crossings_[x.idx() - ideal_overlay_.number_of_original_vertices()];
    crossing.position = (g.halfedge.idx() & 1) ? at_i / (at_i + at_j) : from_right;
    crossing.t = at_t / (at_s + at_t);
    crossing.weight = length(g.halfedge) / whole * (at_s + at_t) / (at_i + at_j);
    if (!(crossing.position >= 0 && crossing.position <= 1 && crossing.t >= 0 && crossing.t <= 1 &&
          crossing.weight > 0 && std::isfinite(crossing.weight)))
      throw Numerical_error("lengths of the conformal map leave the range of double");
  }
}

// The crossings with edges of A, and those with edges of C, are each in order.
void Triple_overlay::merge(Edge_index e)
{
  std::vector<On_edge>& merged = on_edges_[e.idx()];
  std::vector<On_edge> ideal;
  const Overlay& overlay = subdivision_.overlay();
  for (Overlay::Vertex v : overlay.intrinsic_crossings(e))
    merged.push_back({subdivision_.positions().on_intrinsic_edge(v), v.idx(), false});
  for (std::uint32_t i = 0; i + 1 < ideal_overlay_.number_of_input_segments(e); ++i) {
    const std::uint32_t x = ideal_overlay_.input_crossing(e, i).idx() - ideal_overlay_.number_of_original_vertices();
    const double before = ideal.empty() ? 0 : ideal.back().position;
    ideal.push_back({(std::max)(ideal_crossings_[x].position, before), first_ideal_node_ + x, true});
  }
  // Where three circumcircles are one, edges of A and of C cross B at the same place, which only rounding tells apart.
  auto near = merged.begin();
  for (On_edge& x : ideal) {
    while (near != merged.end() && near->position < x.position - same_place)
      ++near;
    if (near != merged.end() && near->position <= x.position + same_place)
      x.position = near->position;
  }
  std::vector<On_edge> both(merged.size() + ideal.size());
  std::merge(merged.begin(), merged.end(), ideal.begin(), ideal.end(), both.begin(),
             [](const On_edge& x, const On_edge& y) { return x.position < y.position; });
  merged = std::move(both);
  for (std::size_t i = 0; i < merged.size(); ++i) {
    index_on_edge_[merged[i].node] = std::uint32_t(i);
    if (merged[i].is_ideal)
      nodes_[merged[i].node] = place_on_input(e, merged[i].position);
  }
}

// A part of the edge between two crossings with A lies in one face of A.
Surface_point Triple_overlay::place_on_input(Edge_index e, double position) const
{
  const Input_layer layer(subdivision_);
  const auto segments = layer.overlay.intrinsic_segments(e);
  std::size_t i = 0;
  double from = 0, to = 1;
  for (Overlay::Vertex v : layer.overlay.intrinsic_crossings(e)) {
    const double x = subdivision_.positions().on_intrinsic_edge(v);
    if (position < x) {
      to = x;
      break;
    }
    from = x;
    ++i;
  }
  const Overlay::Halfedge h = layer.overlay.halfedge(segments.begin()[std::ptrdiff_t(i)]);
  const double t = fraction_of(position, from, to);
  if (const Halfedge_index along = layer.overlay.input_halfedge(h); along.is_valid()) {
    const auto [begin, end] = layer.positions.ends_on_input_halfedge(layer.overlay, h);
    const double x = begin + t * (end - begin);
    return {along, {1 - x, x, 0}};
  }
  const Halfedge_index side = layer.complex.halfedge(layer.overlay.input_face(layer.overlay.face(h)));
  const Coordinates p = corner_coordinates(layer, layer.overlay.opposite(h), side),
                    q = corner_coordinates(layer, h, side);
  Surface_point result{side, {}};
  for (std::size_t k = 0; k < 3; ++k)
    result.coordinates[k] = (1 - t) * p[k] + t * q[k];
  return result;
}

// Starts with the pieces of B and C in a face of B, and divides them by the chords of A.
class Triple_overlay::Face_builder
{
public:
  explicit Face_builder(Triple_overlay& whole)
    : whole_(whole), overlay_(whole.subdivision_.overlay()), ideal_overlay_(whole.ideal_overlay_),
      input_chords_(whole.intrinsic_.number_of_faces()), ideal_faces_(whole.intrinsic_.number_of_faces())
  {
    for (Overlay::Segment s : overlay_.segments())
      if (overlay_.label(s) == Segment_label::INPUT)
        input_chords_[overlay_.intrinsic_face(overlay_.face(overlay_.halfedge(s))).idx()].push_back(
          overlay_.halfedge(s));
    for (Overlay::Face f : ideal_overlay_.faces())
      ideal_faces_[ideal_overlay_.input_face(f).idx()].push_back(f);
  }

  void run(const Progress_function& progress)
  {
    for (Face_index f : whole_.intrinsic_.faces()) {
      if (f.idx() % 16 == 0)
        report_progress(progress, double(f.idx()) / whole_.intrinsic_.number_of_faces(),
                        "the overlay of three triangulations");
      collect_boundary(f);
      collect_chords(f);
      for (Overlay::Face piece : ideal_faces_[f.idx()])
        divide(piece);
    }
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  // Nodes of the face are numbered around its boundary; those inside follow.
  struct Chord
  {
    std::uint32_t a, b;
    Overlay::Halfedge halfedge; // from a to b
    std::vector<std::uint32_t> inner;
  };
  // Between two nodes that follow each other on a chord.
  struct Chord_part
  {
    std::uint32_t chord, position, from, to;
  };
  struct Local_corner
  {
    std::uint32_t local;
    Ideal_point at;             // if it lies on an edge of C
    Halfedge_index ideal, side; // along the side of the piece, of C and of B
    bool is_input;
    bool is_ideal; // whether `at` is set
  };
  using Polygon = std::vector<Local_corner>;

  void collect_boundary(Face_index f)
  {
    const Delta_complex& complex = whole_.intrinsic_;
    nodes_.clear();
    places_.clear();
    sides_ = {complex.halfedge(f), complex.next(complex.halfedge(f)), complex.prev(complex.halfedge(f))};
    for (std::size_t i = 0; i < 3; ++i) {
      starts_[i] = std::uint32_t(nodes_.size());
      const auto add = [&](std::uint32_t node, double position) {
        std::array<double, 3> place{0, 0, 0};
        place[i] = 1 - position;
        place[(i + 1) % 3] = position;
        nodes_.push_back(node);
        places_.push_back(place);
      };
      add(complex.source(sides_[i]).idx(), 0);
      const std::vector<On_edge>& on_edge = whole_.on_edges_[complex.edge(sides_[i]).idx()];
      if ((sides_[i].idx() & 1) == 0)
        for (const On_edge& x : on_edge)
          add(x.node, x.position);
      else
        for (auto x = on_edge.rbegin(); x != on_edge.rend(); ++x)
          add(x->node, 1 - x->position);
    }
    boundary_ = std::uint32_t(nodes_.size());
  }

  // The number of a node on the boundary, by the side of B on which it lies, or which begins at it.
  std::uint32_t local(Halfedge_index side, Overlay::Vertex v, const Overlay& overlay, std::uint32_t first_node) const
  {
    const std::size_t i = side == sides_[0] ? 0 : side == sides_[1] ? 1 : 2;
    if (!overlay.is_crossing(v))
      return starts_[i];
    const Edge_index e = whole_.intrinsic_.edge(side);
    const std::uint32_t index = whole_.index_on_edge_[first_node + v.idx() - overlay.number_of_original_vertices()];
    return starts_[i] + 1 + ((side.idx() & 1) ? std::uint32_t(whole_.on_edges_[e.idx()].size()) - 1 - index : index);
  }
  std::uint32_t local_of_input(Overlay::Halfedge h) const
  {
    return local(overlay_.intrinsic_side(h), overlay_.target(h), overlay_, overlay_.number_of_original_vertices());
  }
  std::uint32_t local_of_ideal(Overlay::Halfedge h) const
  {
    return local(ideal_overlay_.input_side(h), ideal_overlay_.target(h), ideal_overlay_, whole_.first_ideal_node_);
  }

  // All chords of A, and those of C that cross them, with the crossings in order.
  void collect_chords(Face_index f)
  {
    chords_.clear();
    ideal_chords_.clear();
    for (Overlay::Halfedge h : input_chords_[f.idx()])
      chords_.push_back({local_of_input(overlay_.opposite(h)), local_of_input(h), h, {}});
    if (chords_.empty())
      return;
    for (Overlay::Face piece : ideal_faces_[f.idx()]) {
      const Overlay::Halfedge first = ideal_overlay_.halfedge(piece);
      Overlay::Halfedge h = first;
      do {
        if (ideal_overlay_.label(ideal_overlay_.segment(h)) == Segment_label::INTRINSIC && (h.idx() & 1) == 0)
          cross({local_of_ideal(ideal_overlay_.opposite(h)), local_of_ideal(h), h, {}});
        h = ideal_overlay_.next(h);
      } while (h != first);
    }
    for (Chord& chord : chords_)
      sort(chord.a, chord.inner, [&](std::uint32_t x) { return crossing_chord_[x - boundary_]; });
    parts_.clear();
    parts_.resize(nodes_.size());
    for (std::uint32_t c = 0; c < chords_.size(); ++c) {
      const std::vector<std::uint32_t>& inner = chords_[c].inner;
      std::uint32_t from = chords_[c].a;
      for (std::uint32_t i = 0; i <= inner.size(); ++i) {
        const std::uint32_t to = i == inner.size() ? chords_[c].b : inner[i];
        parts_[from].push_back({c, i, from, to});
        from = to;
      }
    }
  }

  // The parts of chords of A between corners of a piece of B and C, in the order of chords.
  std::vector<Chord_part> parts_in(const Polygon& polygon) const
  {
    std::vector<Chord_part> result;
    if (chords_.empty())
      return result;
    std::vector<std::uint32_t> corners;
    for (const Local_corner& corner : polygon)
      corners.push_back(corner.local);
    std::sort(corners.begin(), corners.end());
    for (std::uint32_t x : corners)
      for (const Chord_part& part : parts_[x])
        if (std::binary_search(corners.begin(), corners.end(), part.to))
          result.push_back(part);
    std::sort(result.begin(), result.end(), [](const Chord_part& p, const Chord_part& q) {
      return std::make_pair(p.chord, p.position) < std::make_pair(q.chord, q.position);
    });
    return result;
  }

  // Counted around the boundary from a on.
  std::uint32_t after(std::uint32_t a, std::uint32_t x) const { return (x + boundary_ - a) % boundary_; }
  bool do_cross(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
  {
    if (c == a || c == b || d == a || d == b)
      return false;
    return (after(a, c) < after(a, b)) != (after(a, d) < after(a, b));
  }

  void cross(Chord ideal)
  {
    for (Chord& chord : chords_)
      if (do_cross(ideal.a, ideal.b, chord.a, chord.b)) {
        const std::uint32_t x = std::uint32_t(nodes_.size());
        nodes_.push_back(none);
        crossed_.resize(x + 1 - boundary_);
        crossing_chord_.resize(x + 1 - boundary_);
        crossed_[x - boundary_] = {chord.a, chord.b};
        crossing_chord_[x - boundary_] = {ideal.a, ideal.b};
        ideal.inner.push_back(x);
        chord.inner.push_back(x);
        place_crossing(x, chord, ideal);
      }
    sort(ideal.a, ideal.inner, [&](std::uint32_t x) { return crossed_[x - boundary_]; });
    ideal_chords_.emplace(ideal.halfedge.idx(), std::move(ideal));
  }

  // The chords that cross one from a do not cross each other: the nearer its ends are to a, the earlier it comes.
  template <class Ends>
  void sort(std::uint32_t a, std::vector<std::uint32_t>& inner, const Ends& ends) const
  {
    std::sort(inner.begin(), inner.end(), [&](std::uint32_t x, std::uint32_t y) {
      const auto [p, q] = ends(x);
      const auto [r, s] = ends(y);
      const std::uint32_t x_right = (std::min)(after(a, p), after(a, q)), x_left = (std::max)(after(a, p), after(a, q));
      const std::uint32_t y_right = (std::min)(after(a, r), after(a, s)), y_left = (std::max)(after(a, r), after(a, s));
      return x_right != y_right ? x_right < y_right : x_left > y_left;
    });
  }

  void place_crossing(std::uint32_t x, const Chord& chord, const Chord& ideal)
  {
    const auto &p = places_[chord.a], &q = places_[chord.b], &r = places_[ideal.a], &s = places_[ideal.b];
    // In the plane of the first two coordinates.
    const auto side = [](const std::array<double, 3>& o, const std::array<double, 3>& v,
                         const std::array<double, 3>& w) {
      return (v[0] - o[0]) * (w[1] - o[1]) - (v[1] - o[1]) * (w[0] - o[0]);
    };
    const auto share = [](double a, double b) { return a == b ? 0.5 : (std::min)(1., (std::max)(0., a / (a - b))); };
    const double along_input = share(side(r, s, p), side(r, s, q)), along_ideal = share(side(p, q, r), side(p, q, s));
    const auto [begin, end] = whole_.subdivision_.positions().ends_on_input_halfedge(overlay_, chord.halfedge);
    const double t = begin + along_input * (end - begin);
    nodes_[x] = std::uint32_t(whole_.nodes_.size());
    whole_.nodes_.push_back({overlay_.input_halfedge(chord.halfedge), {1 - t, t, 0}});
    const auto [t_r, weight_r] = on_ideal_edge(ideal_overlay_.opposite(ideal.halfedge), ideal.halfedge);
    const auto [t_s, weight_s] = on_ideal_edge(ideal.halfedge, ideal.halfedge);
    const double u = projective(along_ideal, weight_r, weight_s);
    ideal_places_.resize(x + 1 - boundary_);
    ideal_places_[x - boundary_] = (1 - u) * t_r + u * t_s;
  }

  // The place of the target of h on the edge of C that contains the halfedge `along`, and its weight.
  std::pair<double, double> on_ideal_edge(Overlay::Halfedge h, Overlay::Halfedge along) const
  {
    const Overlay::Vertex v = ideal_overlay_.target(h);
    if (ideal_overlay_.is_crossing(v)) {
      const Ideal_crossing& x = whole_.ideal_crossings_[v.idx() - ideal_overlay_.number_of_original_vertices()];
      return {x.t, x.weight};
    }
    const bool is_forward = (ideal_overlay_.intrinsic_halfedge(along).idx() & 1) == 0, is_end = h == along;
    return {is_forward == is_end ? 1 : 0, whole_.weights_[v.idx()]};
  }

  void divide(Overlay::Face face)
  {
    std::vector<Polygon> polygons(1);
    std::vector<Face_index> inputs(1);
    Polygon& polygon = polygons.front();
    const Overlay::Halfedge first = ideal_overlay_.halfedge(face);
    Overlay::Halfedge before = first, h = ideal_overlay_.next(first);
    do { // the side h, which begins where `before` ends
      const Halfedge_index ideal = ideal_overlay_.intrinsic_halfedge(h), side = ideal_overlay_.input_halfedge(h);
      const std::uint32_t from = local_of_ideal(before), to = local_of_ideal(h);
      const bool is_input =
        side.is_valid() && whole_.subdivision_.overlay().label(
                             *overlay_.intrinsic_segments(whole_.intrinsic_.edge(side)).begin()) == Segment_label::BOTH;
      const auto add = [&](std::uint32_t x, const Ideal_point& at, bool is_ideal) {
        polygon.push_back({x, at, ideal, side, is_input, is_ideal});
      };
      add(from, place(before, h), true);
      if (side.is_valid()) {
        for (std::uint32_t x = (from + 1) % boundary_; x != to; x = (x + 1) % boundary_)
          add_on_side(polygon, x, ideal, side, is_input, before, h);
      } else if (const auto chord = ideal_chords_.find(h.idx() & ~1u); chord != ideal_chords_.end()) {
        std::vector<std::uint32_t> inner = chord->second.inner;
        if ((h.idx() & 1) != 0)
          std::reverse(inner.begin(), inner.end());
        for (std::uint32_t x : inner)
          add(x, {ideal, ideal_places_[x - boundary_]}, true);
      }
      before = h;
      h = ideal_overlay_.next(h);
    } while (before != first);

    for (const Chord_part& part : parts_in(polygon))
      split(polygons, inputs, part.from, part.to, chords_[part.chord].halfedge);
    for (std::size_t i = 0; i < polygons.size(); ++i)
      add_piece(polygons[i], inputs[i], ideal_overlay_.intrinsic_face(face));
  }

  // Where a corner of a piece of B and C, between the sides `before` and `behind`, lies on an edge of C.
  Ideal_point place(Overlay::Halfedge before, Overlay::Halfedge behind) const
  {
    const Overlay::Vertex v = ideal_overlay_.target(before);
    if (!ideal_overlay_.is_crossing(v)) {
      const Halfedge_index side = ideal_overlay_.intrinsic_side(before);
      return {side, double(side.idx() & 1)};
    }
    const Halfedge_index ideal = ideal_overlay_.intrinsic_halfedge(before).is_valid()
                                   ? ideal_overlay_.intrinsic_halfedge(before)
                                   : ideal_overlay_.intrinsic_halfedge(behind);
    return {ideal, whole_.ideal_crossings_[v.idx() - ideal_overlay_.number_of_original_vertices()].t};
  }

  // A crossing with A on the side from the target of `before` to that of h, along an edge of B. Its place is computed in the
  // direction of the edge, so that it is the same on both sides.
  void add_on_side(Polygon& polygon, std::uint32_t x, Halfedge_index ideal, Halfedge_index side, bool is_input,
                   Overlay::Halfedge before, Overlay::Halfedge h)
  {
    const bool is_forward = (side.idx() & 1) == 0;
    const Overlay::Halfedge from = is_forward ? before : h, to = is_forward ? h : before;
    const double t = projective(
      fraction_of(position(x, side), position(local_of_ideal(from), side), position(local_of_ideal(to), side)),
      weight(from), weight(to));
    if (ideal.is_valid()) { // B and C coincide
      polygon.push_back({x, {ideal, ((ideal.idx() ^ side.idx()) & 1) ? 1 - t : t}, ideal, side, is_input, true});
      return;
    }
    polygon.push_back({x, {}, ideal, side, is_input, false});
    const Ideal_point first = place(before, h), second = place(h, ideal_overlay_.next(h));
    between_[x] = is_forward ? Between{first, second, t} : Between{second, first, t};
  }
  // Of a node on a side, in the direction of halfedge 2e.
  double position(std::uint32_t x, Halfedge_index side) const
  {
    const std::size_t i = side == sides_[0] ? 0 : side == sides_[1] ? 1 : 2;
    const bool is_forward = (side.idx() & 1) == 0;
    if (x == starts_[i] || x == starts_[(i + 1) % 3])
      return (x == starts_[i]) == is_forward ? 0 : 1;
    const std::vector<On_edge>& on_edge = whole_.on_edges_[whole_.intrinsic_.edge(side).idx()];
    const std::size_t n = x - starts_[i] - 1;
    return on_edge[is_forward ? n : on_edge.size() - 1 - n].position;
  }
  double weight(Overlay::Halfedge h) const
  {
    const Overlay::Vertex v = ideal_overlay_.target(h);
    return ideal_overlay_.is_crossing(v)
             ? whole_.ideal_crossings_[v.idx() - ideal_overlay_.number_of_original_vertices()].weight
             : whole_.weights_[v.idx()];
  }

  // Divides the polygon that has both nodes; none has them if the part of the chord lies in another piece.
  void split(std::vector<Polygon>& polygons, std::vector<Face_index>& inputs, std::uint32_t from, std::uint32_t to,
             Overlay::Halfedge chord) const
  {
    const auto find = [](Polygon& polygon, std::uint32_t x) {
      return std::find_if(polygon.begin(), polygon.end(), [&](const Local_corner& c) { return c.local == x; });
    };
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      Polygon& polygon = polygons[i];
      const auto p = find(polygon, from), q = find(polygon, to);
      if (p == polygon.end() || q == polygon.end())
        continue;
      std::rotate(polygon.begin(), p, polygon.end());
      const auto end = find(polygon, to);
      const std::size_t n = std::size_t(end - polygon.begin());
      if (n < 2 || n + 1 >= polygon.size())
        return; // along a side
      Polygon right(polygon.begin(), end + 1), left(end, polygon.end());
      left.push_back(polygon.front());
      for (Polygon* part : {&left, &right}) {
        part->back().ideal = part->back().side = Halfedge_index();
        part->back().is_input = true;
      }
      const Delta_complex& input = whole_.subdivision_.input();
      polygon = std::move(left);
      inputs[i] = input.face(overlay_.input_halfedge(chord));
      polygons.push_back(std::move(right));
      inputs.push_back(input.face(input.opposite(overlay_.input_halfedge(chord))));
      return;
    }
  }

  void add_piece(const Polygon& polygon, Face_index input, Face_index ideal)
  {
    Piece piece{{}, input, ideal};
    for (const Local_corner& c : polygon) {
      Corner corner{nodes_[c.local], c.at, c.at, 0, c.ideal, c.is_input};
      if (!c.is_ideal) {
        corner.from = between_[c.local].from;
        corner.to = between_[c.local].to;
        corner.t = between_[c.local].t;
      }
      if (!piece.input.is_valid() && c.side.is_valid())
        piece.input = input_face_at(c);
      piece.corners.push_back(corner);
    }
    whole_.pieces_.push_back(std::move(piece));
  }

  // The face of A beside the part of a side of B that begins at a corner.
  Face_index input_face_at(const Local_corner& corner) const
  {
    const Edge_index e = whole_.intrinsic_.edge(corner.side);
    const std::vector<On_edge>& on_edge = whole_.on_edges_[e.idx()];
    const bool is_forward = (corner.side.idx() & 1) == 0;
    // How many nodes of the edge come up to this corner, in the direction of the side.
    const std::size_t i = corner.side == sides_[0] ? 0 : corner.side == sides_[1] ? 1 : 2;
    const std::uint32_t n = corner.local - starts_[i];
    std::ptrdiff_t passed = 0;
    for (std::uint32_t k = 0; k < n; ++k)
      passed += !on_edge[is_forward ? k : on_edge.size() - 1 - k].is_ideal;
    const auto segments = overlay_.intrinsic_segments(e);
    const Overlay::Halfedge h = overlay_.halfedge(is_forward ? segments.begin()[passed] : segments.end()[-1 - passed]);
    return overlay_.input_face(overlay_.face(is_forward ? h : overlay_.opposite(h)));
  }

  struct Between
  {
    Ideal_point from, to;
    double t;
  };

  Triple_overlay& whole_;
  const Overlay &overlay_, &ideal_overlay_;
  std::vector<std::vector<Overlay::Halfedge>> input_chords_; // for each face of B
  std::vector<std::vector<Overlay::Face>> ideal_faces_;      // likewise
  // Of the present face:
  std::array<Halfedge_index, 3> sides_;
  std::array<std::uint32_t, 3> starts_;
  std::uint32_t boundary_ = 0;                // the number of nodes on it
  std::vector<std::uint32_t> nodes_;          // of the whole
  std::vector<std::array<double, 3>> places_; // barycentric, of the nodes on the boundary
  std::vector<Chord> chords_;
  std::vector<std::vector<Chord_part>> parts_;  // of the chords, by the node where they begin
  std::map<std::uint32_t, Chord> ideal_chords_; // by the even halfedge
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossed_,
    crossing_chord_;                 // the ends of the two chords at a crossing
  std::vector<double> ideal_places_; // of crossings
  std::map<std::uint32_t, Between> between_;
};

void Triple_overlay::divide_faces(const Progress_function& progress) { Face_builder(*this).run(progress); }

} // namespace CGAL::Intrinsic_triangulations::internal
