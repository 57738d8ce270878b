// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From normal coordinates and roundabouts to the overlay graph, in linear time.

#include <CGAL/Intrinsic_triangulations/internal/overlay/Overlay_arrays.h>
#include "Input_edge_tracer.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The segments of intrinsic edges and all crossings are numbered by counting. Then each input edge is followed once
// through the intrinsic triangles, which tells at every crossing which four segments meet. The corners at the vertices,
// where input edges leave between intrinsic ones, and the faces come last.
//
// Vertices that were inserted on input edges divide these into paths, which are followed and numbered one by one.
//
// Most intrinsic triangles are input triangles. Memory access takes most of the time, so they are copied with as little
// of it as possible.
//
// Several threads work on blocks of edges or faces: first all blocks are counted, and the numbers of a block begin
// where the count of all earlier ones ends. So the result is the same as with one thread.
class Overlay_builder
{
  using size_type = Overlay_arrays::size_type;
  using End = Input_edge_tracer::End;

public:
  Overlay_builder(const Delta_complex& intrinsic, const Correspondence& correspondence,
                  const Progress_function& progress, const Block_runner& threads)
    : intrinsic_(intrinsic), input_(correspondence.input()), correspondence_(correspondence),
      coordinates_(correspondence.coordinates()),
      has_inserted_vertices_(correspondence.number_of_inserted_vertices() != 0),
      tracer_(intrinsic, correspondence, overlay_), progress_(progress), threads_(threads)
  {
    CGAL_precondition(correspondence.knows_input());
  }

  Overlay_arrays build()
  {
    number_intrinsic_segments();
    follow_input_edges();
    fill_faces();
    join_paths();
    name_vertex_halfedges();
    return std::move(overlay_);
  }

private:
  bool is_parallel() const { return bool(threads_); }
  static std::size_t block(std::size_t first) { return first / elements_of_block; }

  // Calls f(first, last) for blocks of [0, n): a single one unless there are several threads.
  template <class Function>
  void for_each_block(std::size_t n, const Function& f) const
  {
    if (is_parallel())
      threads_(n, elements_of_block, f);
    else if (n != 0)
      f(std::size_t(0), n);
  }

  // One count for each block of [0, n).
  template <class Count>
  std::vector<Count> make_counts(std::size_t n) const
  {
    return std::vector<Count>(is_parallel() ? block(n) + 1 : 1);
  }

  // Replaces the count of each block by the sum of all earlier ones. Returns the total.
  static std::uint64_t sum_up(std::vector<std::uint64_t>& counts)
  {
    std::uint64_t sum = 0;
    for (std::uint64_t& x : counts)
      sum += std::exchange(x, sum);
    return sum;
  }

  void number_intrinsic_segments()
  {
    const std::size_t n = intrinsic_.number_of_edges();
    overlay_.number_of_original_vertices = intrinsic_.number_of_vertices();
    overlay_.number_of_input_vertices = input_.number_of_vertices();
    overlay_.first_segments.resize(n + 1, default_init);
    auto crossings = make_counts<std::uint64_t>(n), coinciding = crossings;
    for_each_block(n, [&](std::size_t first, std::size_t last) {
      std::uint64_t sum = 0, number_of_coinciding = 0;
      for (std::size_t i = first; i < last; ++i) {
        const Edge_index e{size_type(i)};
        overlay_.first_segments[i] = size_type(i + sum);
        sum += std::uint64_t(coordinates_.number_of_crossings(e));
        number_of_coinciding += coordinates_.is_original(e) ? 1 : 0;
        check_size(sum); // each term is below 2^61: the sum cannot wrap before
      }
      crossings[block(first)] = sum;
      coinciding[block(first)] = number_of_coinciding;
    });
    allocate(sum_up(crossings), sum_up(coinciding));
    if (crossings.size() > 1)
      for_each_block(n, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          overlay_.first_segments[i] += size_type(crossings[block(first)]);
      });

    const Loop_progress progress = part(0, 0.4, n);
    for_each_block(n, [&](std::size_t first, std::size_t last) { fill_intrinsic_segments(first, last, progress); });
  }

  void allocate(std::uint64_t crossings, std::uint64_t coinciding)
  {
    check_size(crossings);
    std::uint64_t number_of_paths = input_.number_of_edges();
    for (Vertex_index v : inserted_vertices())
      number_of_paths += correspondence_.location(v).dimension() == 1 ? 1 : 0;
    // Each chord that an input edge cuts out of an intrinsic triangle adds a face.
    const std::uint64_t number_of_chords = crossings + number_of_paths - coinciding;
    const std::uint64_t number_of_segments = intrinsic_.number_of_edges() + crossings + number_of_chords;
    check_size(number_of_segments);
    overlay_.first_input_segment = size_type(intrinsic_.number_of_edges() + crossings);
    overlay_.first_segments.back() = overlay_.first_input_segment;

    overlay_.halfedges.resize(2 * number_of_segments, default_init);
    overlay_.parents.resize(number_of_segments, default_init);
    overlay_.vertex_halfedges.resize(intrinsic_.number_of_vertices() + crossings, default_init);
    overlay_.faces.resize(intrinsic_.number_of_faces() + number_of_chords, default_init);
    overlay_.coinciding_halfedges.resize(intrinsic_.number_of_edges(), default_init);
    overlay_.input_edges.resize(input_.number_of_edges(), default_init);
    if (has_inserted_vertices_) {
      path_ends_.resize(input_.number_of_edges(), default_init);
      inserted_.resize(correspondence_.number_of_inserted_vertices(), default_init);
    }
  }

  using Iterator = Descriptor_iterator<Vertex_index>;
  Iterator_range<Iterator> inserted_vertices() const
  {
    return make_range(Iterator(input_.number_of_vertices()), Iterator(intrinsic_.number_of_vertices()));
  }
  bool is_inserted(Vertex_index v) const { return correspondence_.is_inserted(v); }

  void fill_intrinsic_segments(std::size_t first, std::size_t last, const Loop_progress& progress)
  {
    size_type segment = overlay_.first_segments[first];
    size_type crossing = intrinsic_.number_of_vertices() + segment - size_type(first);
    for (std::size_t i = first; i < last; ++i) {
      const Edge_index e{size_type(i)};
      progress.at(i);
      const Halfedge_index h = intrinsic_.halfedge(e);
      size_type from = intrinsic_.source(h).idx();
      const size_type last = overlay_.first_segments[i + 1] - 1;
      const bool is_crossed = segment < last;
      while (segment < last) {
        overlay_.parents[segment] = e.idx();
        overlay_.vertex_halfedges[crossing] = 2 * segment;
        set_intrinsic_segment(segment++, from, crossing);
        from = crossing++;
      }
      overlay_.parents[segment] = e.idx();
      set_intrinsic_segment(segment, from, intrinsic_.target(h).idx());
      overlay_.coinciding_halfedges[e.idx()] = Overlay_arrays::null;
      if (!is_crossed && coordinates_.is_original(e))
        note_coinciding(h, segment);
      for (Halfedge_index side : {h, intrinsic_.opposite(h)})
        if (intrinsic_.is_border(side)) // a border edge is one segment
          record(first_part(side)).next = first_part(intrinsic_.next(side));
      ++segment;
    }
  }

  static void check_size(std::uint64_t number_of_segments)
  {
    if (number_of_segments >= std::uint64_t(1) << 31)
      throw Integer_overflow_error("the overlay has 2^31 segments or more: too many edges cross each other");
  }

  void note_coinciding(Halfedge_index h, size_type segment)
  {
    const Halfedge_index in_input = correspondence_.input_halfedge(h);
    overlay_.coinciding_halfedges[intrinsic_.edge(h).idx()] = in_input.idx();
    const bool runs_against = (in_input.idx() & 1) != 0;
    const Halfedge_index along = runs_against ? intrinsic_.opposite(h) : h;
    const size_type first = 2 * segment + (runs_against ? 1 : 0);
    if (!has_inserted_vertices_)
      overlay_.input_edges[input_.edge(in_input).idx()] = {first, 1, 0};
    else
      note_path(input_.edge(in_input), intrinsic_.source(along), intrinsic_.target(along), first, 1);
  }

  // Notes a path of an input edge, in the direction of its halfedge 2e.
  void note_path(Edge_index input_edge, Vertex_index from, Vertex_index to, size_type first, size_type count)
  {
    (is_inserted(from) ? inserted(from).onward : overlay_.input_edges[input_edge.idx()]) = {first, count, 0};
    (is_inserted(to) ? inserted(to).back : path_ends_[input_edge.idx()]) = (first + 2 * (count - 1)) ^ 1;
  }

  // The faces are not known yet; border halfedges never get one.
  void set_intrinsic_segment(size_type segment, size_type source, size_type target)
  {
    record(2 * segment) = {Overlay_arrays::null, target, Overlay_arrays::null};
    record(2 * segment + 1) = {Overlay_arrays::null, source, Overlay_arrays::null};
  }

  void set_ends(size_type segment, size_type source, size_type target)
  {
    record(2 * segment).target = target;
    record(2 * segment + 1).target = source;
  }

  void follow_input_edges()
  {
    const Loop_progress progress = part(0.4, 0.7, intrinsic_.number_of_edges());
    if (is_parallel()) {
      follow_in_blocks();
    } else {
      size_type segment = overlay_.first_input_segment;
      for (Edge_index e : intrinsic_.edges()) {
        progress.at(e.idx());
        tracer_.for_each_path_across(e, [&](Halfedge_index input_halfedge, const End& source, std::int64_t position) {
          add_input_edge(input_halfedge, source, segment, [&](const auto& visit) {
            return tracer_.follow(source.ij, position,
                                  [&](const Input_edge_tracer::Crossing& x) { visit(crossed(x)); });
          });
        });
      }
    }
  }

  // Segment numbers depend on the lengths of all earlier paths, so the paths of a block are kept until these are known.
  void follow_in_blocks()
  {
    struct Path
    {
      Halfedge_index input_halfedge;
      End source, target;
      std::size_t end; // after its last crossing
    };
    struct Paths
    {
      std::vector<Path> paths;
      std::vector<Crossed> crossings;
    };
    const std::size_t n = intrinsic_.number_of_edges();
    auto blocks = make_counts<Paths>(n);
    for_each_block(n, [&](std::size_t first, std::size_t last) {
      Paths& here = blocks[block(first)];
      for (std::size_t i = first; i < last; ++i)
        tracer_.for_each_path_across(
          Edge_index(size_type(i)), [&](Halfedge_index input_halfedge, const End& source, std::int64_t position) {
            const End target = tracer_.follow(
              source.ij, position, [&](const Input_edge_tracer::Crossing& x) { here.crossings.push_back(crossed(x)); });
            here.paths.push_back({input_halfedge, source, target, here.crossings.size()});
          });
    });
    std::vector<std::uint64_t> segments;
    for (const Paths& paths : blocks)
      segments.push_back(paths.crossings.size() + paths.paths.size());
    sum_up(segments);
    for_each_block(n, [&](std::size_t first, std::size_t) {
      size_type segment = overlay_.first_input_segment + size_type(segments[block(first)]);
      const Paths& here = blocks[block(first)];
      std::size_t i = 0;
      for (const Path& path : here.paths)
        add_input_edge(path.input_halfedge, path.source, segment, [&](const auto& visit) {
          for (; i < path.end; ++i)
            visit(here.crossings[i]);
          return path.target;
        });
    });
  }

  // A crossing, given by the edge that is crossed.
  struct Crossed
  {
    Halfedge_index halfedge; // from its left
    size_type segment;       // of its edge, before the crossing
  };
  Crossed crossed(const Input_edge_tracer::Crossing& x) const
  {
    return {x.halfedge, overlay_.first_segments[intrinsic_.edge(x.halfedge).idx()] + size_type(x.position)};
  }

  // Makes the segments of an input edge, numbered from `segment` on, which is advanced past them.
  // for_each_crossing(visit) visits what the edge crosses and returns its end at the target.
  template <class Function>
  void add_input_edge(Halfedge_index input_halfedge, const End& source, size_type& segment,
                      const Function& for_each_crossing)
  {
    const size_type edge = input_.edge(input_halfedge).idx(), first = segment;
    size_type from = (has_inserted_vertices_ ? tracer_.vertex(source) : input_.source(input_halfedge)).idx();
    const auto end_segment = [&](size_type to) {
      overlay_.parents[segment] = edge;
      set_ends(segment++, from, to);
      from = to;
    };
    const End target = for_each_crossing([&](const Crossed& x) { end_segment(cross(x, segment)); });
    end_segment((has_inserted_vertices_ ? tracer_.vertex(target) : input_.target(input_halfedge)).idx());
    if (has_inserted_vertices_)
      note_path(Edge_index(edge), tracer_.vertex(source), tracer_.vertex(target), 2 * first, segment - first);
    else
      overlay_.input_edges[edge] = {2 * first, segment - first, 0};
    link_end(source, 2 * first);
    link_end(target, 2 * (segment - 1) + 1);
  }

  // Links the segment that leaves a corner, if it is the only one, between the two sides that leave it.
  void link_end(const End& end, size_type out)
  {
    if (end.count == 1) {
      link(first_part(intrinsic_.prev(end.ij)), out);
      link(out, first_part(intrinsic_.opposite(intrinsic_.next(end.ij))));
    }
  }

  // Links the four segments that meet at the crossing where an input segment ends; returns the crossing.
  size_type cross(const Crossed& crossing, size_type input_segment)
  {
    // The segments that leave the crossing, counterclockwise from the direction of halfedge 2e.
    const size_type before = crossing.segment;
    const size_type ahead = 2 * (before + 1), back = 2 * before + 1;
    size_type left = 2 * input_segment + 1, right = 2 * (input_segment + 1);
    const Edge_index e = intrinsic_.edge(crossing.halfedge);
    if (crossing.halfedge != intrinsic_.halfedge(e))
      std::swap(left, right);
    link(ahead, left);
    link(left, back);
    link(back, right);
    link(right, ahead);
    return overlay_.number_of_original_vertices + before - e.idx();
  }

  // Links two consecutive halfedges out of a vertex, counterclockwise, around the face between them.
  void link(size_type out, size_type next_out) { record(next_out ^ 1).next = out; }

  size_type first_part(Halfedge_index h) const
  {
    const size_type e = intrinsic_.edge(h).idx();
    if (h == intrinsic_.halfedge(Edge_index(e)))
      return 2 * overlay_.first_segments[e];
    return 2 * (overlay_.intrinsic_segments_end(e) - 1) + 1;
  }

  // The first part of an input halfedge, out of one of its vertices.
  size_type first_part_in_input(Halfedge_index h, Vertex_index v) const
  {
    const Edge_index e = input_.edge(h);
    const bool is_onward = h == input_.halfedge(e);
    if (is_inserted(v))
      return is_onward ? inserted(v).onward.first : inserted(v).back;
    const Overlay_arrays::Input_edge& edge = overlay_.input_edges[e.idx()];
    return is_onward                ? edge.first
           : has_inserted_vertices_ ? path_ends_[e.idx()]
                                    : (edge.first + 2 * (edge.count - 1)) ^ 1;
  }

  void fill_faces()
  {
    const std::size_t n = intrinsic_.number_of_faces();
    const Loop_progress progress = part(0.7, 1, n);
    auto faces = make_counts<std::uint64_t>(n);
    if (faces.size() > 1) {
      for_each_block(n, [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f)
          faces[block(first)] += number_of_parts(Face_index(size_type(f)));
      });
      sum_up(faces);
    }
    for_each_block(n, [&](std::size_t first, std::size_t last) {
      fill_faces(first, last, size_type(faces[block(first)]), progress);
    });
  }

  // The number of faces into which chords divide a face.
  std::uint64_t number_of_parts(Face_index f) const
  {
    const Triangle_crossings t = tracer_.triangle_crossings(intrinsic_.halfedge(f));
    return std::uint64_t(1 + t.c_i + t.c_j + t.c_k + t.e_i + t.e_j + t.e_k);
  }

  void fill_faces(std::size_t first, std::size_t last, size_type face, const Loop_progress& progress)
  {
    for (std::size_t i = first; i < last; ++i) {
      const Face_index f{size_type(i)};
      progress.at(i);
      const Halfedge_index h = intrinsic_.halfedge(f);
      const Side ij = side(h), jk = side(intrinsic_.next(h)), ki = side(intrinsic_.prev(h));
      if (ij.first == ij.last && jk.first == jk.last && ki.first == ki.last) {
        copy_input_face(face++, f, ij.first, jk.first, ki.first);
        continue;
      }
      const Triangle_crossings crossings(ij.number_of_crossings(), jk.number_of_crossings(), ki.number_of_crossings());
      link_corner(jk, ki, crossings.e_k);
      link_corner(ki, ij, crossings.e_i);
      link_corner(ij, jk, crossings.e_j);
      for (const Side* side : {&ij, &jk, &ki})
        for (size_type part = (std::min)(side->first, side->last), end = (std::max)(side->first, side->last);
             part <= end; part += 2)
          if (record(part).face == Overlay_arrays::null)
            make_face(face++, part, f);
    }
    CGAL_postcondition(last < intrinsic_.number_of_faces() || face == overlay_.faces.size());
  }

  // A side of an intrinsic face, with its parts from the source to the target.
  struct Side
  {
    Halfedge_index halfedge;
    size_type first, last;

    std::int64_t number_of_crossings() const
    {
      return (std::int64_t((std::max)(first, last)) - (std::min)(first, last)) / 2;
    }
  };
  Side side(Halfedge_index h) const
  {
    const size_type e = intrinsic_.edge(h).idx();
    const size_type first = 2 * overlay_.first_segments[e], last = 2 * (overlay_.first_segments[e + 1] - 1);
    return h == intrinsic_.halfedge(Edge_index(e)) ? Side{h, first, last} : Side{h, last + 1, first + 1};
  }

  void copy_input_face(size_type face, Face_index f, size_type ij, size_type jk, size_type ki)
  {
    record(ij).next = jk;
    record(jk).next = ki;
    record(ki).next = ij;
    record(ij).face = record(jk).face = record(ki).face = face;
    const size_type input_halfedge = overlay_.input_halfedge(ij);
    overlay_.faces[face] = {ij, f.idx(),
                            input_halfedge != Overlay_arrays::null
                              ? input_face(input_halfedge)
                              : uncrossed_input_face(intrinsic_, correspondence_, intrinsic_.halfedge(f)).idx()};
  }

  // Links the corner between two sides where n input halfedges leave; a single one has been linked already.
  void link_corner(const Side& in, const Side& out, std::int64_t n)
  {
    if (n == 0)
      record(in.last).next = out.first;
    if (n < 2)
      return;
    size_type before = out.first;
    for_each_start(intrinsic_, correspondence_, out.halfedge, n, [&](Halfedge_index input_halfedge) {
      const size_type next = first_part_in_input(input_halfedge, intrinsic_.source(out.halfedge));
      link(before, next);
      before = next;
    });
    link(before, in.last ^ 1);
  }

  size_type input_face(size_type input_halfedge) const { return input_.face(Halfedge_index(input_halfedge)).idx(); }

  // In an intrinsic face that is cut, each piece has a side on an intrinsic edge and one on a cutting input edge. (A
  // piece bounded by input edges alone would be an input triangle with the same corners as the intrinsic one: the same
  // triangle, which nothing cuts.)
  void make_face(size_type face, size_type first, Face_index intrinsic_face)
  {
    size_type on_input_edge = first, h = first;
    do {
      Overlay_arrays::Halfedge& side = record(h);
      side.face = face;
      on_input_edge = (std::max)(on_input_edge, h); // segments of input edges come last
      h = side.next;
    } while (h != first);
    overlay_.faces[face] = {first, intrinsic_face.idx(), input_face(overlay_.input_halfedge(on_input_edge))};
  }

  // Lists the parts of input edges that consist of several paths.
  void join_paths()
  {
    for (Vertex_index v : inserted_vertices()) {
      const Surface_point& location = correspondence_.location(v);
      if (location.dimension() != 1)
        continue;
      const Edge_index e = input_.edge(internal::side_of(input_, location));
      Overlay_arrays::Input_edge& edge = overlay_.input_edges[e.idx()];
      if (edge.is_split)
        continue;
      const size_type first = size_type(overlay_.split_parts.size());
      for (Overlay_arrays::Input_edge path = edge;;) {
        for (size_type i = 0; i < path.count; ++i)
          overlay_.split_parts.push_back(path.first + 2 * i);
        const Vertex_index end(record(overlay_.split_parts.back()).target);
        if (!is_inserted(end))
          break;
        path = inserted(end).onward;
      }
      edge = {first, size_type(overlay_.split_parts.size()) - first, 1};
    }
  }

  void name_vertex_halfedges()
  {
    for_each_block(intrinsic_.number_of_vertices(), [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const Halfedge_index h = intrinsic_.halfedge(Vertex_index(size_type(v)));
        overlay_.vertex_halfedges[v] = h.is_valid() ? first_part(intrinsic_.opposite(h)) ^ 1 : Overlay_arrays::null;
      }
    });
  }

  // With several threads, progress is reported only at the beginning of the part: threads cannot report it later.
  Loop_progress part(double begin, double end, std::size_t number_of_elements) const
  {
    static constexpr const char* what = "the construction of the overlay";
    static const Progress_function nobody;
    if (is_parallel())
      report_progress(progress_, begin, what);
    return Loop_progress(is_parallel() ? nobody : progress_, what, begin, end, number_of_elements);
  }

  // A vertex that was inserted on an input edge.
  struct Inserted
  {
    Overlay_arrays::Input_edge onward; // the path from there
    size_type back;                    // the path that ends there, seen from there
  };
  Inserted& inserted(Vertex_index v) { return inserted_[v.idx() - input_.number_of_vertices()]; }
  const Inserted& inserted(Vertex_index v) const { return inserted_[v.idx() - input_.number_of_vertices()]; }

  Overlay_arrays::Halfedge& record(size_type h) { return overlay_.halfedges[h]; }

  const Delta_complex& intrinsic_;
  const Delta_complex& input_;
  const Correspondence& correspondence_;
  const Normal_coordinates& coordinates_;
  const bool has_inserted_vertices_;
  const Input_edge_tracer tracer_;
  const Progress_function& progress_;
  const Block_runner& threads_;
  Overlay_arrays overlay_;
  // If vertices were inserted:
  Large_vector<size_type> path_ends_; // for each input edge, the path to its target, seen from there
  Large_vector<Inserted> inserted_;
};

Overlay_arrays build_overlay(const Delta_complex& intrinsic, const Correspondence& correspondence,
                             const Progress_function& progress, const Block_runner& threads)
{
  return Overlay_builder(intrinsic, correspondence, progress, threads).build();
}

} // namespace CGAL::Intrinsic_triangulations::internal
