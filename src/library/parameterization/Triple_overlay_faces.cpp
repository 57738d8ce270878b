// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The pieces of Triple_overlay.h: each face of B, divided by chords of A and of C.

#include "Chord_arrangement.h"
#include "Triple_overlay.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// What is at the fraction t of a line with homogeneous weights at its ends, in inhomogeneous coordinates.
double projective(double t, double weight_from, double weight_to)
{
  const double sum = (1 - t) * weight_from + t * weight_to;
  return sum > 0 ? t * weight_to / sum : t;
}

double between(double t, double from, double to) { return (1 - t) * from + t * to; }

} // namespace

class Triple_overlay::Face_builder
{
public:
  explicit Face_builder(Triple_overlay& whole)
    : whole_(whole), overlay_(whole.subdivision_.overlay()), ideal_overlay_(whole.ideal_overlay_),
      input_ends_(overlay_.number_of_segments(), none), ideal_ends_(ideal_overlay_.number_of_segments(), none)
  {}

  void run(const Progress_function& progress)
  {
    for (Face_index f : whole_.intrinsic_.faces()) {
      if (f.idx() % 16 == 0)
        report_progress(progress, double(f.idx()) / whole_.intrinsic_.number_of_faces(),
                        "the overlay of three triangulations");
      collect_boundary(f);
      arrange();
      place_sectors();
      place_crossings_on_sides();
      arrangement_.for_each_piece([this](const std::vector<Dart>& piece) { add_piece(piece); });
    }
  }

private:
  static constexpr std::uint32_t none = Chord_arrangement::none;
  using Dart = Chord_arrangement::Dart;
  struct Chord
  {
    Chord_arrangement::Chord ends;
    Overlay::Halfedge halfedge; // from a to b
  };
  // On the boundary, which is numbered counterclockwise from the first corner.
  struct Node
  {
    std::uint32_t number;
    std::array<double, 3> place;  // barycentric
    double position;              // on the edge, in the direction of 2e
    Overlay::Halfedge input_part; // the part of a side, by crossings with A, that begins here or around it
    std::uint32_t ideal_part;     // likewise, by crossings with C
    bool is_ideal;                // or a corner: begins an ideal part
  };
  struct Ideal_part
  {
    Overlay::Halfedge halfedge;
    std::uint32_t from, to; // nodes
    std::array<double, 2> positions;
  };

  void collect_boundary(Face_index f)
  {
    const Delta_complex& complex = whole_.intrinsic_;
    nodes_.clear();
    parts_.clear();
    input_chords_.clear();
    ideal_chords_.clear();
    Halfedge_index side = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, side = complex.next(side))
      collect_side(side, i);
    parts_.back().to = 0;
  }

  void collect_side(Halfedge_index side, std::size_t i)
  {
    const Edge_index e = whole_.intrinsic_.edge(side);
    const std::vector<On_edge>& on_edge = whole_.on_edges_[e.idx()];
    const bool is_forward = (side.idx() & 1) == 0;
    const auto segments = overlay_.intrinsic_segments(e);
    const std::uint32_t last = ideal_overlay_.number_of_input_segments(e) - 1;
    std::uint32_t inputs = 0, ideals = 0; // passed
    const auto input_part = [&] {
      return is_forward ? overlay_.halfedge(segments.begin()[inputs])
                        : overlay_.opposite(overlay_.halfedge(segments.end()[-1 - std::ptrdiff_t(inputs)]));
    };
    const auto add = [&](std::uint32_t number, double position, bool is_ideal) {
      const std::uint32_t here = std::uint32_t(nodes_.size());
      if (is_ideal) {
        if (!parts_.empty())
          parts_.back().to = here;
        const Overlay::Halfedge part = ideal_overlay_.input_part(e, is_forward ? ideals : last - ideals);
        parts_.push_back(
          {is_forward ? part : ideal_overlay_.opposite(part), here, 0, {position, is_forward ? 1. : 0.}});
      }
      std::array<double, 3> place{0, 0, 0};
      place[i] = is_forward ? 1 - position : position;
      place[(i + 1) % 3] = is_forward ? position : 1 - position;
      nodes_.push_back({number, place, position, input_part(), std::uint32_t(parts_.size()) - 1, is_ideal});
    };
    const auto end_parts = [&](std::uint32_t node, bool of_input, bool of_ideal) {
      if (of_input)
        collect_ends(overlay_, input_part(), node, input_ends_, input_chords_, Segment_label::INPUT);
      if (of_ideal)
        collect_ends(ideal_overlay_, parts_.back().halfedge, node, ideal_ends_, ideal_chords_,
                     Segment_label::INTRINSIC);
    };
    add(whole_.intrinsic_.source(side).idx(), is_forward ? 0 : 1, true);
    for (std::size_t k = 0; k < on_edge.size(); ++k) {
      const On_edge& x = on_edge[is_forward ? k : on_edge.size() - 1 - k];
      end_parts(std::uint32_t(nodes_.size()), !x.is_ideal, x.is_ideal);
      if (x.is_ideal) {
        parts_.back().positions[1] = x.position;
        ++ideals;
      } else {
        ++inputs;
      }
      add(x.node, x.position, x.is_ideal);
    }
    end_parts(i == 2 ? 0 : std::uint32_t(nodes_.size()), true, true);
  }

  // The chords that end where a part of the boundary does, clockwise. The second end completes a chord.
  void collect_ends(const Overlay& overlay, Overlay::Halfedge part, std::uint32_t node,
                    std::vector<std::uint32_t>& ends, std::vector<Chord>& chords, Segment_label label) const
  {
    for (Overlay::Halfedge out = overlay.next(part); overlay.label(overlay.segment(out)) == label;
         out = overlay.next(overlay.opposite(out))) {
      std::uint32_t& end = ends[overlay.segment(out).idx()];
      if (end == none)
        end = node;
      else
        chords.push_back({{end, node}, overlay.opposite(out)});
    }
  }

  void arrange()
  {
    std::vector<Chord_arrangement::Chord> chords;
    for (const Chord& chord : input_chords_)
      chords.push_back(chord.ends);
    for (const Chord& chord : ideal_chords_)
      chords.push_back(chord.ends);
    arrangement_.build(std::uint32_t(nodes_.size()), std::move(chords), input_chords_.size());
    inner_.clear();
    for (const Chord_arrangement::Crossing& x : arrangement_.crossings())
      inner_.push_back(place_crossing(input_chords_[x.first], ideal_chords_[x.second - input_chords_.size()]));
  }

  bool is_ideal(const Dart& d) const { return d.chord != none && d.chord >= input_chords_.size(); }
  // The halfedge of C along which a dart runs; null if there is none.
  Halfedge_index ideal_halfedge(const Dart& d) const
  {
    if (d.chord == none)
      return ideal_overlay_.intrinsic_halfedge(parts_[nodes_[d.source].ideal_part].halfedge);
    if (!is_ideal(d))
      return Halfedge_index();
    const Overlay::Halfedge h = ideal_chords_[d.chord - input_chords_.size()].halfedge;
    return ideal_overlay_.intrinsic_halfedge(d.is_forward ? h : ideal_overlay_.opposite(h));
  }

  // The point of C where a halfedge of C meets the boundary; at a corner, it begins there or ends.
  Ideal_point ideal_point(std::uint32_t node, Halfedge_index h, bool begins) const
  {
    const std::uint32_t number = nodes_[node].number;
    if (number >= whole_.first_ideal_node_)
      return {h, whole_.ideal_crossings_[number - whole_.first_ideal_node_].t};
    return {h, ((h.idx() & 1) != 0) == begins ? 1. : 0.};
  }

  // Chords of C divide the angle at a node into sectors. In each, the node is a point on a side of another face of C.
  void place_sectors()
  {
    first_sectors_.assign(nodes_.size(), {});
    sectors_.assign(2 * arrangement_.chords().size(), {});
    last_sectors_.assign(nodes_.size(), {});
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      const std::uint32_t x = parts_[p].from, first = arrangement_.first_end(x), end = arrangement_.first_end(x + 1);
      std::uint32_t i = first;
      while (i < end && !is_ideal(arrangement_.end(i)))
        ++i;
      Ideal_point sector;
      if (const Halfedge_index h = ideal_overlay_.intrinsic_halfedge(parts_[p].halfedge); h.is_valid())
        sector = ideal_point(x, h, true);
      else if (i < end)
        sector = ideal_point(x, whole_.ideal_.opposite(ideal_halfedge(arrangement_.end(i))), false);
      else
        sector =
          ideal_point(x, ideal_overlay_.intrinsic_side(parts_[p == 0 ? parts_.size() - 1 : p - 1].halfedge), true);
      first_sectors_[x] = sector;
      for (i = first; i < end; ++i) {
        if (const Dart d = arrangement_.end(i); is_ideal(d))
          sector = ideal_point(x, ideal_halfedge(d), true);
        sectors_[i] = sector;
      }
      last_sectors_[x] = sector;
    }
  }

  // Crossings of A and B lie between points of C on the same side. All is computed in the direction of the edge of B, so
  // that it is the same on both sides.
  void place_crossings_on_sides()
  {
    on_sides_.resize(nodes_.size());
    for (std::uint32_t x = 0; x < nodes_.size(); ++x) {
      const Node& node = nodes_[x];
      if (node.is_ideal)
        continue;
      const Ideal_part& part = parts_[node.ideal_part];
      std::uint32_t from = part.from, to = part.to;
      Ideal_point first = first_sectors_[from], second = last_sectors_[to];
      const bool is_forward = part.positions[0] <= part.positions[1];
      if (!is_forward) {
        std::swap(from, to);
        std::swap(first, second);
      }
      const auto [low, high] = std::minmax(part.positions[0], part.positions[1]);
      const double t = fraction_of(node.position, low, high), weight_from = weight(from), weight_to = weight(to),
                   in_new_metric = projective(t, weight_from, weight_to);
      whole_.node_weights_[node.number] = between(t, weight_from, weight_to);
      const Halfedge_index along = ideal_overlay_.intrinsic_halfedge(part.halfedge);
      if (along.is_valid()) { // B and C coincide
        const Ideal_point at{along, ((along.idx() & 1) == 0) == is_forward ? in_new_metric : 1 - in_new_metric};
        on_sides_[x] = {at, at, 0};
      } else {
        on_sides_[x] = {first, second, in_new_metric};
      }
    }
  }
  double weight(std::uint32_t node) const { return whole_.node_weights_[nodes_[node].number]; }

  // Of chords that cross.
  struct Inner_node
  {
    std::uint32_t number;
    double t; // on the edge of C
  };
  Inner_node place_crossing(const Chord& input, const Chord& ideal)
  {
    const auto &p = nodes_[input.ends.a].place, &q = nodes_[input.ends.b].place, &r = nodes_[ideal.ends.a].place,
               &s = nodes_[ideal.ends.b].place;
    // In the plane of the first two coordinates.
    const auto side = [](const std::array<double, 3>& o, const std::array<double, 3>& v,
                         const std::array<double, 3>& w) {
      return (v[0] - o[0]) * (w[1] - o[1]) - (v[1] - o[1]) * (w[0] - o[0]);
    };
    const auto share = [](double a, double b) { return a == b ? 0.5 : (std::min)(1., (std::max)(0., a / (a - b))); };
    const double along_input = share(side(r, s, p), side(r, s, q)), along_ideal = share(side(p, q, r), side(p, q, s));
    const auto [begin, end] = whole_.subdivision_.positions().ends_on_input_halfedge(overlay_, input.halfedge);
    const double t = between(along_input, begin, end);
    const std::uint32_t number = std::uint32_t(whole_.nodes_.size());
    whole_.nodes_.push_back({overlay_.input_halfedge(input.halfedge), {1 - t, t, 0}});
    const Halfedge_index h = ideal_overlay_.intrinsic_halfedge(ideal.halfedge);
    const double weight_r = weight(ideal.ends.a), weight_s = weight(ideal.ends.b);
    whole_.node_weights_.push_back(between(along_ideal, weight_r, weight_s));
    return {number, between(projective(along_ideal, weight_r, weight_s), ideal_point(ideal.ends.a, h, true).t,
                            ideal_point(ideal.ends.b, h, false).t)};
  }

  void add_piece(const std::vector<Dart>& darts)
  {
    Piece piece{{}, Face_index()};
    for (std::size_t i = 0; i < darts.size(); ++i) {
      const Dart &before = darts[i == 0 ? darts.size() - 1 : i - 1], &d = darts[i];
      Corner corner;
      if (d.source >= nodes_.size()) {
        const Inner_node& node = inner_[d.source - nodes_.size()];
        corner.node = node.number;
        corner.from = {ideal_halfedge(is_ideal(d) ? d : before), node.t};
      } else {
        corner.node = nodes_[d.source].number;
        if (nodes_[d.source].is_ideal)
          corner.from = d.chord == none ? first_sectors_[d.source] : sectors_[arrangement_.end_at_source(d)];
        else
          std::tie(corner.from, corner.to, corner.t) = on_sides_[d.source];
      }
      corner.ideal = ideal_halfedge(d);
      if (d.chord == none) {
        const Overlay::Halfedge part = nodes_[d.source].input_part;
        corner.input = overlay_.input_halfedge(part);
        piece.input = overlay_.input_face(overlay_.face(part));
      } else if (!is_ideal(d)) {
        const Overlay::Halfedge h = input_chords_[d.chord].halfedge;
        corner.input = overlay_.input_halfedge(d.is_forward ? h : overlay_.opposite(h));
        piece.input = whole_.subdivision_.input().face(corner.input);
      }
      piece.corners.push_back(corner);
    }
    whole_.pieces_.push_back(std::move(piece));
  }

  Triple_overlay& whole_;
  const Overlay &overlay_, &ideal_overlay_;
  std::vector<std::uint32_t> input_ends_, ideal_ends_; // the first end of a chord, by its segment
  // Of the present face:
  std::vector<Node> nodes_;
  std::vector<Ideal_part> parts_;
  std::vector<Chord> input_chords_, ideal_chords_;
  Chord_arrangement arrangement_;
  std::vector<Inner_node> inner_;
  std::vector<Ideal_point> first_sectors_, last_sectors_,
    sectors_; // of nodes; likewise; that begin at an end of a chord
  std::vector<std::tuple<Ideal_point, Ideal_point, double>> on_sides_; // the crossings of A and B
};

void Triple_overlay::divide_faces(const Progress_function& progress) { Face_builder(*this).run(progress); }

} // namespace CGAL::Intrinsic_triangulations::internal
