// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact decisions and trustworthy numbers from the input and the integers alone: the only interface of the exact layer.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/reports.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
struct Surface_point;
}

namespace CGAL::Intrinsic_triangulations::internal {

class Correspondence;
class Flip_log;
class Input_surface;
class Surface_lease;
struct Known_corner;
struct Two_corners;
class Engine_numbers;
class Engine_restorer;
class Exact_fallback;
class Residues;
struct Triangle_piece;
class Vertex_positions;

// The exact engine: a triangulation, the input that it came from, and exact decisions about both.
//
// It has the connectivity, follows each change of it, and knows where the input lies in it (see Correspondence). Every
// answer is a function of the input and of the connectivity, however the flips led there.
//
// Without an input it is only a connectivity. `keep_input()` gives it one, which everything but changes requires.
//
// Its layers are folders, from the bottom up: history (integers, and what an edge crosses), metric (the input), layout
// (triangles of the input laid out one after the other), and decide (signs from layouts). Engine_numbers rounds
// layouts, and Saved_triangulation replaces the triangulation by one from a file.
//
// Several threads may call const member functions at once: each has memory of its own, and the first one that needs the
// integers computes them while the others wait. Queries throw Integer_overflow_error if these leave 64 bits,
// Undecided_error if a demanded proof of a tie takes too long, and Cancelled_error if the function in
// `decisions().interruption` says so.
class Exact_engine
{
public:
  // A corner in double-doubles with error bounds.
  using Corner = Triangle_corner<Bounded_double_double>;
  // The corners opposite to an edge, k to its left and l to its right.
  using Opposite_corners = internal::Opposite_corners<Bounded_double_double>;

  explicit Exact_engine(Delta_complex connectivity);

  // Caches are not copied.
  Exact_engine(const Exact_engine& other);
  Exact_engine(Exact_engine&& other) noexcept;
  Exact_engine& operator=(Exact_engine other) noexcept;
  ~Exact_engine();

  // From now on the current connectivity is the input, with this metric.
  void keep_input(Input_metric metric);
  bool keeps_input() const { return memory_ != nullptr; }

  const Delta_complex& connectivity() const { return connectivity_; }
  // Where the input lies in the triangulation. \pre `prepare()` was called, and not `begin_log()` since
  const Correspondence& correspondence() const;
  const Input_metric& metric() const { return metric_; }

  // ---------------------------------------------------------------- changes: an exception leaves everything as it was,
  // as far as answers can tell

  // \return whether the new edge is known to be a straight line between two of the points
  bool flip(const Hinge_halfedges& around)
  {
    const bool is_straight = memory_ && log_or_follow(around);
    connectivity_.flip(around);
    return is_straight;
  }
  // The information that a flip loses: the halfedges of both faces and of both ends of the edge, and the planes in
  // which the faces are known to lie.
  struct Forgotten
  {
    std::array<Halfedge_index, 2> of_faces, of_ends;
    std::array<std::uint32_t, 2> planes;
  };
  // As long as the engine is not copied, queries do not change the result.
  Forgotten forgotten_by_flip(const Hinge_halfedges& around) const;
  // Undoes the last flip that was not undone yet. Never throws. \pre no `begin_log()` since
  // \param around the halfedges around the edge before the flip
  // \param forgotten the result of `forgotten_by_flip(around)` before it
  void flip_back(const Hinge_halfedges& around, const Forgotten& forgotten);

  // Flips are logged from now on until the next query, so that each takes the least time: for algorithms that consist
  // of flips. Flips of other functions, which are few and between queries, are followed at once. O(1).
  void begin_log();
  // Which flips are still to be followed. \pre `keeps_input()`
  const Flip_log& log() const;
  // Flips in parts of the triangulation, each of which belongs to one thread. At the end, when no thread flips, the
  // engine takes them over.
  // \pre no query is made from the last `begin_log()` on until then
  class Logs
  {
  public:
    class Log
    {
    public:
      explicit Log(Exact_engine& engine) : engine_(&engine) {}
      void flip(const Hinge_halfedges& around)
      {
        if (engine_->keeps_input())
          flips_.push_back(around);
        engine_->connectivity_.flip(around);
      }

    private:
      friend class Logs;
      Exact_engine* engine_;
      std::vector<Hinge_halfedges> flips_;
    };

    // \param most the maximum number of logs
    Logs(Exact_engine& engine, std::size_t most);
    Logs(const Logs&) = delete;
    Logs& operator=(const Logs&) = delete;
    ~Logs();
    Log& next() { return logs_.emplace_back(engine_); }

  private:
    Exact_engine& engine_;
    std::vector<Log> logs_;
  };

  // `halfedge(f)` of the face f in which the piece lies.
  Halfedge_index halfedge_of_face(const Triangle_piece& piece) const;
  // \param location where the vertex lies: strictly inside a face of the input, and in `piece`
  Vertex_index split_face(const Triangle_piece& piece, const Surface_point& location);
  // \param h a halfedge of an edge that coincides with an input edge
  // \param location where the vertex lies: on that input edge
  Vertex_index split_edge(Halfedge_index h, const Surface_point& location);
  // Removes an inserted vertex in the middle of three faces. Never throws if it was the last one that was inserted.
  // \param first to undo a split: the new `halfedge(f)` of the faces that it split
  Removed_elements unsplit_face(Vertex_index v, std::initializer_list<Halfedge_index> first = {});
  // Removes an inserted vertex, the target of `h`, on a straight line of two edges. Likewise.
  Removed_elements unsplit_edge(Halfedge_index h, std::initializer_list<Halfedge_index> first = {});

  // ---------------------------------------------------------------- decisions

  // The settings and statistics of decisions. \pre `keeps_input()`
  Decisions& decisions();
  const Decisions& decisions() const;

  // Computes the integers and recovers the input if necessary; all queries do so themselves. O(size + number of flips)
  // if there are flips in the log, and O(1) otherwise. With threads, the integers are computed while the input is
  // recovered.
  template <class ConcurrencyTag = Sequential_tag>
  void prepare() const
  {
    if (!is_prepared())
      prepare(block_runner<ConcurrencyTag>());
  }
  void prepare(const Block_runner& run) const;
  // Caches what all edges cross, for work that asks for most of it.
  void keep_crossings() const;

  // The methods that a test may use.
  enum class Means {
    PLANES,       // only that both faces lie in one plane; there may be no answer
    SHORT_STRIPS, // and layouts where few input edges cross the faces that are not straight: likewise
    ALL,
    UNFOLDING // layouts and the stages after them, without knowledge from earlier flips, such as straight faces
  };
  // The sign of `cot k + cot l` for the angles opposite to an edge, and the stage that decided it. Where both faces
  // have zero area, the sign is `NEGATIVE` if both angles are π, and `ZERO` otherwise. There is always an answer to
  // `ALL` and to `UNFOLDING`. \pre `e` lies between two different faces
  std::optional<Exact_decision> test(Edge_index e, Means means = Means::ALL) const;
  // The sign on the way to a Delaunay triangulation: counts how the test was decided, and keeps data that makes tests
  // after the next flips cheap. `corners` receives the two corners, unless both faces lie in one plane in space.
  Sign decide(Edge_index e, std::optional<Opposite_corners>& corners);

  // Whether the two faces of `e` form a strictly convex quadrilateral. \pre `e` lies between two different faces
  bool is_convex(Edge_index e) const;
  // `NEGATIVE` only if some flip was made in a nonconvex hinge.
  Sign sign_of_area(Face_index f) const;
  bool has_length_zero(Edge_index e) const;
  // On which side of `h` a point of the input lies: `POSITIVE` to the left, `ZERO` on it.
  // \param h a halfedge that coincides with no input edge
  // \param position the number of crossings after which `h` runs through the input face of the point
  Sign side_of(Halfedge_index h, std::int64_t position, const Surface_point& point) const;

  // ---------------------------------------------------------------- corners in the unit of the metric, with bounds

  // The corner opposite to h. Uses earlier layouts, and keeps those that take long. \pre h is not a border halfedge
  Corner kept_corner(Halfedge_index h);
  // The corners at a vertex: for each face the side opposite to it, counterclockwise.
  std::vector<std::pair<Halfedge_index, Corner>> corners_at(Vertex_index v) const;
  // The same. Uses earlier layouts and keeps new ones if edges at the vertex cross many input edges.
  std::vector<std::pair<Halfedge_index, Corner>> kept_corners_at(Vertex_index v);

  // The input with the images of its metric, for layouts; it belongs to the caller while the lease lives.
  // \pre `prepare()` was called
  Surface_lease input_surface() const;

private:
  friend class Engine_numbers;
  friend class Engine_restorer;

  std::unique_ptr<Input_surface> new_surface() const;
  Surface_lease surface_for_query() const;
  Surface_lease prepared_surface() const;

  struct Memory;
  class Corners;
  class Known_corners;
  class Kept_corners;
  using Image_corner = Triangle_corner<Residues>;

  // The number of flips per edge, which bounds the memory of the log.
  static constexpr std::size_t longest_log = 8;
  // The number of crossings of the edges at a vertex up to which layouts are not worth keeping.
  static constexpr std::int64_t long_star = 4;
  // How many flips may lay out faces for each close call and each requested corner.
  static constexpr std::size_t layouts_for_question = 4;
  // The number of input quantities that can be laid out in a few microseconds.
  static constexpr double short_strip = 256;

  bool log_or_follow(const Hinge_halfedges& around);
  bool follow(const Hinge_halfedges& around);
  bool follow_faces(const Hinge_halfedges& around);
  void set_first(std::initializer_list<Halfedge_index> first);
  bool is_prepared() const;
  void find_straight_faces() const;
  void recognize_straight_face(Halfedge_index h);
  void prepare_insertion();
  void remove(const Removed_elements& removed);
  template <class SplitIntegers>
  void split_faces(const std::vector<Face_index>& faces, std::size_t number_of_new_edges, std::size_t number_of_parts,
                   const Surface_point& location, const SplitIntegers& split_integers);
  void join_faces(Face_index f, std::initializer_list<Face_index> faces);
  Vertex_positions positions() const;
  template <class Straight_faces>
  std::optional<Sign> sign_in_plane(const Two_corners& at, Straight_faces& straight_faces) const;
  std::optional<Sign> sign_by_corners(const Two_corners& at, const Opposite_corners& corners) const;
  std::optional<Bounded_double_double> weight_by_other_diagonal(Halfedge_index h,
                                                                const Opposite_corners& corners) const;
  Corner known_corner(Halfedge_index h, Input_surface& surface) const;
  double number_of_quantities(Halfedge_index h) const;
  void carry_images();
  Known_corner laid_out(Halfedge_index h);
  Corner developed_corner(Halfedge_index h, bool in_doubles = false);
  std::optional<Image_corner> image_of_straight_corner(Halfedge_index h) const;
  std::optional<Sign> sign_by_images(const Two_corners& at, const Opposite_corners& corners, Input_surface& surface,
                                     bool makes_images) const;

  // Like the public ones, with memory taken by the caller.
  Exact_decision test(Edge_index e, Input_surface& surface) const;
  Sign sign_of_area(Face_index f, Input_surface& surface) const;
  Corner corner(Halfedge_index h, Input_surface& surface) const;
  Corner unfolded_corner(Halfedge_index h, Input_surface& surface) const;
  Bounded_double_double squared_length(Edge_index e, Input_surface& surface) const;
  Exact_fallback exact_fallback(Input_surface& surface) const;
  bool is_straight(Face_index f) const;
  Corner straight_corner(Halfedge_index h, bool in_doubles = false) const;

  Delta_complex connectivity_;
  Input_metric metric_;
  std::unique_ptr<Memory> memory_; // null without an input
};

// The side of a face whose opposite corner takes the least time. \pre `engine.prepare()` was called
Halfedge_index quickest_side(const Exact_engine& engine, Face_index f);

// The functions of a Correspondence that Intrinsic_triangulation forwards, so that its users need not include that
// class.
const Delta_complex& input(const Correspondence& correspondence);
std::int64_t crossings(const Correspondence& correspondence, Edge_index e);
Halfedge_index input_halfedge(const Correspondence& correspondence, Halfedge_index h);
bool is_inserted(const Correspondence& correspondence, Vertex_index v);
const Surface_point& location(const Correspondence& correspondence, Vertex_index v);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H
