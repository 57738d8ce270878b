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
#include <iterator>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr const char* overlay_of_three = "the overlay of three triangulations";
constexpr double same_place = 0x1p-44; // on an edge of length 1

double between(double t, double from, double to) { return (1 - t) * from + t * to; }
double fraction_of(double x, double from, double to)
{
  return to > from ? (std::min)(1., (std::max)(0., (x - from) / (to - from))) : 0.5;
}
// The fraction in inhomogeneous coordinates of the point at the fraction t of a line with homogeneous weights at its
// ends.
double projective(double t, double weight_from, double weight_to)
{
  const double sum = between(t, weight_from, weight_to);
  return sum > 0 ? t * weight_to / sum : t;
}
// The part of the boundary of a face of B after `part`; `visit` is called for the chords that end between them,
// clockwise.
template <class Visit>
Overlay::Halfedge next_part(const Overlay& overlay, Overlay::Halfedge part, Segment_label chords, const Visit& visit)
{
  Overlay::Halfedge out = overlay.next(part);
  for (; overlay.label(overlay.segment(out)) == chords; out = overlay.next(overlay.opposite(out)))
    visit(out);
  return out;
}

} // namespace

Triple_overlay::Triple_overlay(const Common_subdivision& subdivision, const Delta_complex& ideal, Overlay ideal_overlay,
                               const std::vector<double>& lengths, const std::vector<double>& u,
                               const Progress_function& progress)
  : subdivision_(subdivision), overlay_(subdivision.overlay()), intrinsic_(subdivision.intrinsic()), ideal_(ideal),
    ideal_overlay_(std::move(ideal_overlay)), lengths_(lengths), first_ideal_node_(overlay_.number_of_vertices()),
    ideal_crossings_(ideal_overlay_.number_of_crossings()), nodes_(first_ideal_node_ + ideal_crossings_.size()),
    weights_(nodes_.size()), input_begins_(overlay_.number_of_halfedges()),
    ideal_begins_(ideal_overlay_.number_of_halfedges()), numbers_(ideal_overlay_.number_of_faces(), none)
{
  const double middle =
    u.empty() ? 0 : (*std::max_element(u.begin(), u.end()) + *std::min_element(u.begin(), u.end())) / 2;
  std::transform(u.begin(), u.end(), weights_.begin(), [&](double x) { return std::exp(middle - x); });
  for (Overlay::Vertex v : overlay_.crossings()) {
    const double t = subdivision.positions().on_input_edge(v);
    nodes_[v.idx()] = {subdivision.input().halfedge(overlay_.input_edge(v)), {1 - t, t, 0}};
  }
  for (Edge_index e : ideal.edges()) {
    if (e.idx() % 1024 == 0)
      report_progress(progress, 0, overlay_of_three);
    place_ideal_crossings(e);
  }
  for (Edge_index e : intrinsic_.edges())
    merge(e);
  first_on_edge_.push_back(on_edges_.size());
}

void Triple_overlay::for_each_piece(const Visit& visit, const Progress_function& progress)
{
  nodes_.resize(first_ideal_node_ + ideal_crossings_.size());
  weights_.resize(nodes_.size());
  for (Face_index f : intrinsic_.faces()) {
    if (f.idx() % 16 == 0)
      report_progress(progress, double(f.idx()) / intrinsic_.number_of_faces(), overlay_of_three);
    collect_boundary(f);
    for (Overlay::Halfedge h : chords_)
      if (input_begins_[h.idx()] < input_begins_[overlay_.opposite(h).idx()])
        follow(h);
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      collect_places(faces_[i]);
      divide_by_chords(parts_[i], visit);
      numbers_[faces_[i].idx()] = none;
    }
  }
}

// λ-lengths from the apex before the first gate to source and target of each gate, an edge of B that is crossed from
// right to left, and to the apex after the last one: each from the one before by Ptolemy's formula, so nothing cancels.
std::vector<std::array<double, 2>> Triple_overlay::lengths_to(const std::vector<Halfedge_index>& gates) const
{
  std::array<double, 2> now{length(intrinsic_.prev(gates[0])), length(intrinsic_.next(gates[0]))};
  std::vector<std::array<double, 2>> result{now};
  for (std::size_t k = 0; k < gates.size(); ++k) {
    const Halfedge_index front = intrinsic_.opposite(gates[k]);
    const double apex =
      (now[1] * length(intrinsic_.next(front)) + now[0] * length(intrinsic_.prev(front))) / length(front);
    now[k + 1 == gates.size() || gates[k + 1] == intrinsic_.next(front) ? 1 : 0] = apex;
    result.push_back(now);
  }
  return result;
}

// With s and t the ends of an edge of C that crosses one of B, j to the left and i to the right,
//   λ_jt λ_js X_i + λ_it λ_is X_j  and  (λ_ij / λ_st) (λ_it λ_jt X_s + λ_is λ_js X_t)
// are the same point.
void Triple_overlay::place_ideal_crossings(Edge_index e)
{
  std::vector<Halfedge_index> gates, back;
  for (Overlay::Vertex x : ideal_overlay_.intrinsic_crossings(e))
    gates.push_back(ideal_overlay_.crossing_input_halfedge(x));
  if (gates.empty())
    return;
  for (auto g = gates.rbegin(); g != gates.rend(); ++g)
    back.push_back(intrinsic_.opposite(*g));
  const std::vector<std::array<double, 2>> to_s = lengths_to(gates), to_t = lengths_to(back);
  const double whole = to_s.back()[1];
  const Halfedge_index along = ideal_.halfedge(e);
  const double weight_s = weights_[ideal_.source(along).idx()], weight_t = weights_[ideal_.target(along).idx()];
  std::size_t k = 0;
  for (Overlay::Vertex x : ideal_overlay_.intrinsic_crossings(e)) {
    const auto [is, js] = to_s[k];
    const auto [jt, it] = to_t[gates.size() - 1 - k];
    const double at_i = jt * js, at_j = it * is, at_s = it * jt * weight_s, at_t = is * js * weight_t;
    const std::uint32_t number = x.idx() - ideal_overlay_.number_of_original_vertices();
    Ideal_crossing& crossing = ideal_crossings_[number];
    crossing = {((gates[k].idx() & 1) ? at_i : at_j) / (at_i + at_j), at_t / (at_s + at_t)};
    double& weight = weights_[first_ideal_node_ + number];
    weight = length(gates[k++]) / whole * (at_s + at_t) / (at_i + at_j);
    if (!(crossing.position >= 0 && crossing.position <= 1 && crossing.t >= 0 && crossing.t <= 1 && weight > 0 &&
          std::isfinite(weight)))
      throw Numerical_error("lengths of the conformal map leave the range of double");
  }
}

// Merges the crossings with edges of A and those with edges of C, each of which are in order. The latter get places
// on the input: a part between two crossings with A lies in one face of A.
void Triple_overlay::merge(Edge_index e)
{
  std::vector<On_edge> given, ideal;
  for (Overlay::Vertex v : overlay_.intrinsic_crossings(e))
    given.push_back({subdivision_.positions().on_intrinsic_edge(v), v.idx(), false});
  for (std::uint32_t i = 0; i + 1 < ideal_overlay_.number_of_input_segments(e); ++i) {
    const std::uint32_t x = ideal_overlay_.input_crossing(e, i).idx() - ideal_overlay_.number_of_original_vertices();
    const double before = ideal.empty() ? 0 : ideal.back().position;
    ideal.push_back({(std::max)(ideal_crossings_[x].position, before), first_ideal_node_ + x, true});
  }
  // Where three circumcircles are one, edges of A and of C cross B at the same place, which only rounding tells apart.
  auto near = given.begin();
  for (On_edge& x : ideal) {
    while (near != given.end() && near->position < x.position - same_place)
      ++near;
    if (near != given.end() && near->position <= x.position + same_place)
      x.position = near->position;
  }
  first_on_edge_.push_back(on_edges_.size());
  std::merge(given.begin(), given.end(), ideal.begin(), ideal.end(), std::back_inserter(on_edges_),
             [](const On_edge& x, const On_edge& y) { return x.position < y.position; });
  std::size_t part = 0;
  for (std::size_t k = first_on_edge_.back(); k < on_edges_.size(); ++k)
    if (const On_edge& x = on_edges_[k]; x.is_ideal) {
      const double from = part == 0 ? 0 : given[part - 1].position,
                   to = part == given.size() ? 1 : given[part].position;
      nodes_[x.node] = place_on_input(overlay_.halfedge(overlay_.intrinsic_segments(e).begin()[std::ptrdiff_t(part)]),
                                      fraction_of(x.position, from, to));
    } else {
      ++part;
    }
}

Surface_point Triple_overlay::place_on_input(Overlay::Halfedge part, double t) const
{
  const Input_layer layer(subdivision_);
  if (const Halfedge_index along = overlay_.input_halfedge(part); along.is_valid()) {
    const auto [begin, end] = layer.ends(part);
    const double x = begin + t * (end - begin);
    return {along, {1 - x, x, 0}};
  }
  const Halfedge_index side = layer.complex.halfedge(overlay_.input_face(overlay_.face(part)));
  const Coordinates p = corner_coordinates(layer, overlay_.opposite(part), side),
                    q = corner_coordinates(layer, part, side);
  return {side, {between(t, p[0], q[0]), between(t, p[1], q[1]), between(t, p[2], q[2])}};
}

void Triple_overlay::collect_boundary(Face_index f)
{
  local_.clear();
  chords_.clear();
  crossings_.clear();
  faces_.clear();
  Halfedge_index side = intrinsic_.halfedge(f);
  const Halfedge_index last = intrinsic_.prev(side);
  const Edge_index e = intrinsic_.edge(last);
  const Intrinsic_layer layer(subdivision_);
  // The parts before the present node.
  Overlay::Halfedge input = layer.part(last, layer.number_of_crossings(e)),
                    ideal = (last.idx() & 1) == 0
                              ? ideal_overlay_.input_part(e, ideal_overlay_.number_of_input_segments(e) - 1)
                              : ideal_overlay_.opposite(ideal_overlay_.input_part(e, 0));
  for (std::size_t i = 0; i < 3; ++i, side = intrinsic_.next(side)) {
    const bool is_forward = (side.idx() & 1) == 0;
    const auto add = [&](std::uint32_t number, double position, bool is_on_input, bool is_ideal) {
      const std::uint32_t here = std::uint32_t(local_.size());
      Local_node node{number, is_ideal, {0, 0, 0}, {}, ideal_overlay_.face(ideal)};
      node.place[i] = is_forward ? 1 - position : position;
      node.place[(i + 1) % 3] = is_forward ? position : 1 - position;
      if (is_on_input)
        input = next_part(overlay_, input, Segment_label::INPUT, [&](Overlay::Halfedge out) {
          input_begins_[out.idx()] = here;
          chords_.push_back(out);
        });
      node.input_part = input;
      if (is_ideal) {
        ideal = next_part(ideal_overlay_, ideal, Segment_label::INTRINSIC,
                          [&](Overlay::Halfedge out) { ideal_begins_[out.idx()] = here; });
        ideal_begins_[ideal.idx()] = here;
        if (std::uint32_t& n = numbers_[ideal_overlay_.face(ideal).idx()]; n == none) {
          n = std::uint32_t(faces_.size());
          faces_.push_back(ideal_overlay_.face(ideal));
        }
      }
      local_.push_back(node);
    };
    add(intrinsic_.source(side).idx(), is_forward ? 0 : 1, true, true);
    const std::size_t number = intrinsic_.edge(side).idx(), begin = first_on_edge_[number],
                      end = first_on_edge_[number + 1];
    for (std::size_t k = 0; k < end - begin; ++k) {
      const On_edge& x = on_edges_[is_forward ? begin + k : end - 1 - k];
      add(x.node, x.position, !x.is_ideal, x.is_ideal);
    }
  }
  size_of_boundary_ = std::uint32_t(local_.size());
  if (parts_.size() < faces_.size())
    parts_.resize(faces_.size());
  for (std::size_t i = 0; i < faces_.size(); ++i)
    parts_[i].clear();
}

// Cuts a chord of A where chords of C are between its ends.
void Triple_overlay::follow(Overlay::Halfedge chord)
{
  const std::uint32_t a = input_begins_[chord.idx()], b = input_begins_[overlay_.opposite(chord).idx()];
  Overlay::Face f = local_[a].start;
  std::uint32_t from = a;
  const auto exit = [&] { // the side beyond which b is
    const Overlay::Halfedge first = ideal_overlay_.halfedge(f);
    Overlay::Halfedge h = first;
    do {
      const std::uint32_t to_b = after(source(h), b);
      if (is_chord(h) && to_b > 0 && to_b < after(source(h), target(h)))
        return h;
      h = ideal_overlay_.next(h);
    } while (h != first);
    return Overlay::Halfedge();
  };
  for (Overlay::Halfedge h = exit(); h.is_valid(); h = exit()) {
    const Overlay::Face before = std::exchange(f, ideal_overlay_.face(ideal_overlay_.opposite(h)));
    if (a == source(h) || a == target(h)) { // it begins beyond this side
      local_[a].start = f;
      continue;
    }
    parts_[numbers_[before.idx()]].push_back({from, std::uint32_t(local_.size()), chord});
    from = std::uint32_t(local_.size());
    cross(chord, ideal_overlay_.segment(h), (h.idx() & 1) == 0);
  }
  parts_[numbers_[f.idx()]].push_back({from, b, chord});
}

// \param leads_right whether the chord ends to the right of the segment of C
void Triple_overlay::cross(Overlay::Halfedge chord, Overlay::Segment segment, bool leads_right)
{
  const Overlay::Halfedge ideal = ideal_overlay_.halfedge(segment);
  const std::uint32_t a = input_begins_[chord.idx()], b = input_begins_[overlay_.opposite(chord).idx()],
                      c = source(ideal), d = target(ideal);
  const auto &p = local_[a].place, &q = local_[b].place, &r = local_[c].place, &s = local_[d].place;
  // In the plane of the first two coordinates.
  const auto side = [](const std::array<double, 3>& o, const std::array<double, 3>& v, const std::array<double, 3>& w) {
    return (v[0] - o[0]) * (w[1] - o[1]) - (v[1] - o[1]) * (w[0] - o[0]);
  };
  const auto share = [](double x, double y) { return x == y ? 0.5 : (std::min)(1., (std::max)(0., x / (x - y))); };
  const double along_input = share(side(r, s, p), side(r, s, q)), along_ideal = share(side(p, q, r), side(p, q, s));
  const auto [begin, end] = subdivision_.positions().ends_on_input_halfedge(overlay_, chord);
  const double x = between(along_input, begin, end), weight_c = weight(c), weight_d = weight(d);
  const Halfedge_index h = ideal_overlay_.intrinsic_halfedge(ideal);
  crossings_.push_back(
    {segment.idx(), after(c, leads_right ? b : a), size_of_boundary_ - after(c, leads_right ? a : b),
     std::uint32_t(local_.size()),
     between(projective(along_ideal, weight_c, weight_d), ideal_point(c, h, true).t, ideal_point(d, h, false).t)});
  local_.push_back({std::uint32_t(nodes_.size()), false, {}, {}, {}});
  nodes_.push_back({overlay_.input_halfedge(chord), {1 - x, x, 0}});
  weights_.push_back(between(along_ideal, weight_c, weight_d));
}

// Where a halfedge of C meets the boundary; at a corner, it begins or ends.
Triple_overlay::Ideal_point Triple_overlay::ideal_point(std::uint32_t node, Halfedge_index h, bool begins) const
{
  const std::uint32_t number = local_[node].number;
  if (number >= first_ideal_node_)
    return {h, ideal_crossings_[number - first_ideal_node_].t};
  return {h, ((h.idx() & 1) != 0) == begins ? 1. : 0.};
}

// Collects the places around a face of B and C.
void Triple_overlay::collect_places(Overlay::Face f)
{
  sides_.clear();
  corners_.clear();
  Overlay::Halfedge h = ideal_overlay_.halfedge(f);
  do {
    const Overlay::Halfedge before = h;
    h = ideal_overlay_.next(h);
    const Halfedge_index along = ideal_overlay_.intrinsic_halfedge(h),
                         along_before = ideal_overlay_.intrinsic_halfedge(before);
    sides_.push_back(h);
    corners_.push_back(along.is_valid()          ? ideal_point(source(h), along, true)
                       : along_before.is_valid() ? ideal_point(source(h), along_before, false)
                                                 : ideal_point(source(h), ideal_overlay_.intrinsic_side(before), true));
  } while (h != ideal_overlay_.halfedge(f));
  places_.clear();
  for (std::size_t k = 0; k < sides_.size(); ++k)
    collect_side(sides_[k], corners_[k], corners_[(k + 1) % sides_.size()]);
  number_of_place_.resize(local_.size());
  for (std::uint32_t k = 0; k < places_.size(); ++k)
    number_of_place_[places_[k].local] = k;
}

// Collects the source of a side, and the nodes on it.
void Triple_overlay::collect_side(Overlay::Halfedge h, Ideal_point first, Ideal_point second)
{
  const Halfedge_index along = ideal_overlay_.intrinsic_halfedge(h);
  const auto add = [&](std::uint32_t node, const Ideal_point& from, const Ideal_point& to, double t) {
    Place place{{local_[node].number, from, to, t, along, {}}, {}, node, std::uint32_t(places_.size()) + 1};
    if (!is_chord(h)) {
      place.corner.input = overlay_.input_halfedge(local_[node].input_part);
      place.input = overlay_.input_face(overlay_.face(local_[node].input_part));
    }
    places_.push_back(place);
  };
  std::uint32_t from = source(h), to = target(h);
  add(from, first, {}, 0);
  if (is_chord(h)) {
    const std::uint32_t s = ideal_overlay_.segment(h).idx();
    const auto begin = std::lower_bound(crossings_.begin(), crossings_.end(), Crossing{s, 0, 0, 0, 0}),
               end = std::lower_bound(begin, crossings_.end(), Crossing{s + 1, 0, 0, 0, 0});
    for (std::ptrdiff_t k = 0, n = end - begin; k < n; ++k) {
      const Crossing& x = begin[(h.idx() & 1) == 0 ? k : n - 1 - k];
      add(x.node, {along, x.t}, {}, 0);
    }
    return;
  }
  // Crossings of A and B, in the direction of the edge of B, so that they are the same on both sides.
  const Halfedge_index side = ideal_overlay_.input_halfedge(h);
  const bool is_forward = (side.idx() & 1) == 0;
  const Halfedge_index start = intrinsic_.halfedge(intrinsic_.face(side));
  const std::size_t i = side == start ? 0 : side == intrinsic_.next(start) ? 1 : 2, k = is_forward ? (i + 1) % 3 : i;
  const std::uint32_t begin = from + 1;
  if (!is_forward) {
    std::swap(from, to);
    std::swap(first, second);
  }
  for (std::uint32_t x = begin; x < size_of_boundary_ && !local_[x].is_ideal; ++x) {
    const double t = fraction_of(local_[x].place[k], local_[from].place[k], local_[to].place[k]),
                 in_new_metric = projective(t, weight(from), weight(to));
    weights_[local_[x].number] = between(t, weight(from), weight(to));
    if (along.is_valid()) { // B and C coincide
      const Ideal_point at{along, ((along.idx() & 1) == 0) == is_forward ? in_new_metric : 1 - in_new_metric};
      add(x, at, at, 0);
    } else {
      add(x, first, second, in_new_metric);
    }
  }
}

// Divides by chords that do not cross: the shortest ones cut off pieces first.
void Triple_overlay::divide_by_chords(std::vector<Part_of_chord>& chords, const Visit& visit)
{
  for (Part_of_chord& c : chords) {
    c = {number_of_place_[c.from], number_of_place_[c.to], c.chord};
    if (c.from > c.to)
      c = {c.to, c.from, overlay_.opposite(c.chord)};
  }
  std::sort(chords.begin(), chords.end(),
            [](const Part_of_chord& c, const Part_of_chord& d) { return c.to - c.from < d.to - d.from; });
  const auto collect_piece = [this](std::uint32_t first, std::uint32_t last) {
    piece_.corners.clear();
    for (std::uint32_t k = first; k <= last; k = places_[k].next) {
      piece_.corners.push_back(places_[k].corner);
      if (places_[k].input.is_valid())
        piece_.input = places_[k].input;
    }
  };
  for (const Part_of_chord& c : chords) {
    Place& p = places_[c.from];
    const Halfedge_index there = overlay_.input_halfedge(c.chord), back = subdivision_.input().opposite(there);
    if (p.next != c.to) { // otherwise it is along the side
      collect_piece(c.from, c.to);
      piece_.corners.back().ideal = Halfedge_index();
      piece_.corners.back().input = back;
      piece_.input = subdivision_.input().face(back);
      visit(piece_);
      p.corner.ideal = Halfedge_index();
      p.input = subdivision_.input().face(there);
      p.next = c.to;
    }
    p.corner.input = there;
  }
  collect_piece(0, std::uint32_t(places_.size()) - 1);
  visit(piece_);
}

} // namespace CGAL::Intrinsic_triangulations::internal
