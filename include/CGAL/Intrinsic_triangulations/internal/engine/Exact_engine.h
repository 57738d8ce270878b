// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact decisions and trustworthy numbers from the input and the integers alone: the one interface of the exact layer.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/reports.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Block_runner.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Scratch_pool.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <array>
#include <atomic>
#include <complex>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

class Input_surface;
class Exact_fallback;
class Residues;
class Vertex_positions;
class Crossed_edges;
struct Saved_triangulation;
template <class Corner, class Image_corner>
struct Known_corner;

// The exact engine: a triangulation, the input that it came from, and what exact arithmetic says about both.
//
// It has the connectivity, follows each change of it, and knows where the input lies in it (see Correspondence). Every
// answer is a function of the input and of the connectivity, whatever the flips were that led there.
//
// Without an input it is a connectivity only. `keep_input()` gives it one, and all but the changes need that.
//
// Its layers are folders, from the bottom up: history (integers, and what an edge crosses), metric (the input), layout
// (triangles of the input laid out one after the other), and decide (signs from layouts).
//
// All const member functions may be called by several threads at once: each works with memory of its own, and the first
// one that needs the integers computes them while the others wait. Queries throw Integer_overflow_error if these leave
// 64 bits, Undecided_error if a proof is demanded of a tie that takes too long, and Cancelled_error if the function
// that was given to `set_interruption()` says so.
class Exact_engine
{
public:
  // A corner in double-doubles with error bounds.
  using Corner = Triangle_corner<Bounded_double_double>;
  // The corners opposite to an edge, k to its left and l to its right.
  using Opposite_corners = internal::Opposite_corners<Bounded_double_double>;

  explicit Exact_engine(Delta_complex connectivity);

  // What only speeds up queries is not copied.
  Exact_engine(const Exact_engine& other);
  Exact_engine(Exact_engine&& other) noexcept;
  Exact_engine& operator=(Exact_engine other) noexcept;
  ~Exact_engine();

  // From now on the current connectivity is the input, with this metric.
  void keep_input(Input_metric metric);
  bool keeps_input() const { return memory_ != nullptr; }

  const Delta_complex& connectivity() const { return connectivity_; }
  // Where the input lies in the triangulation. \pre `prepare()` was called, and not `begin_journal()` since
  const Correspondence& correspondence() const { return correspondence_; }
  const Input_metric& metric() const { return metric_; }

  // ---------------------------------------------------------------- changes: an exception leaves everything as it was,
  // as far as answers can tell

  // \return whether the new edge is known to be a straight line between two of the points
  bool flip(const Hinge_halfedges& around)
  {
    bool is_straight = false;
    if (memory_) {
      if (is_asked_.load(std::memory_order_relaxed) ||
          correspondence_.number_of_journaled_flips() >= longest_journal * std::size_t(connectivity_.number_of_edges()))
        is_straight = flip_and_follow(around);
      else
        correspondence_.flip(connectivity_, around);
    }
    connectivity_.flip(around);
    return is_straight;
  }
  // Undoes a flip, the last one that was not undone. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Hinge_halfedges& around);
  // Sets `halfedge(f)`, for who undoes a change.
  void set_halfedge(Face_index f, Halfedge_index h) { connectivity_.set_halfedge(f, h); }

  // Flips are logged from now on until the next query, so that each takes the least time: for algorithms that consist
  // of flips. Those of other functions, which are few and between queries, are followed at once. O(1).
  void begin_journal();
  // A flip in a part of the triangulation that a thread has to itself. What was flipped so is appended before the next
  // query.
  // \pre no query was made since `begin_journal()`
  void flip_in_block(const Hinge_halfedges& around) { connectivity_.flip(around); }
  void append(std::vector<Hinge_halfedges> flips);
  // So many calls of append() do not throw then.
  void make_room_for_journals(std::size_t number);

  // \param location where the vertex lies: strictly inside a face of the input, and in `piece`
  Vertex_index split_face(const Triangle_piece& piece, const Surface_point& location);
  // \param h a halfedge of an edge that coincides with an input edge
  // \param location where the vertex lies: on that input edge
  Vertex_index split_edge(Halfedge_index h, const Surface_point& location);
  // Removes an inserted vertex in the middle of three faces. Never throws if it was the last one that was inserted.
  Removed_elements unsplit_face(Vertex_index v);
  // Removes an inserted vertex, the target of `h`, on a straight line of two edges. Likewise.
  Removed_elements unsplit_edge(Halfedge_index h);

  // Replaces the triangulation by one that a file says has come from this input. All of that is checked, exactly.
  // Its numbers stay there.
  // \pre nothing was flipped, and `saved` has an entry for each of its elements
  // \exception Invalid_surface_error if it is none; then this can only be destroyed
  // \param is_known whether the numbers of a face are known to be right
  void restore(Saved_triangulation& saved, const Block_runner& run, const std::function<bool(Face_index)>& is_known);
  // Whether a face is known to be a triangle in space. Numbers that are rounded depend on that in the last place.
  bool is_known_to_be_straight(Face_index f) const
  {
    find_straight_faces();
    return is_straight(f);
  }

  // ---------------------------------------------------------------- how decisions are made

  // What they accept as a tie.
  void set_tie_proof(Tie_proof tie_proof);
  Tie_proof tie_proof() const;
  // A function that is called from time to time during a single decision that takes long: if it returns `false`, the
  // decision ends with a Cancelled_error. Threads that decide call it, several at once if they do. An empty one, as at
  // the beginning, ends none; copies do not take it over. Returns the one before.
  std::function<bool()> set_interruption(std::function<bool()> go_further);
  const Interruption& interruption() const;
  // How the tests were decided, and those that others have counted.
  Stage_counts& stage_counts();
  const Stage_counts& stage_counts() const;

  // ---------------------------------------------------------------- decisions

  // Computes the integers and recovers the input, where that was not done yet; all queries do so themselves. O(size +
  // number of flips) if there is a journal of flips, and O(1) otherwise. With threads, the integers are computed while
  // the input is recovered.
  template <class ConcurrencyTag = Sequential_tag>
  void prepare() const
  {
    if (!is_prepared())
      prepare(block_runner<ConcurrencyTag>());
  }

  // The sign of `cot k + cot l` for the angles opposite to `e`. Where both faces have zero area, it is `NEGATIVE` if
  // both angles are π, and `ZERO` otherwise. \pre `e` lies between two different faces
  Sign sign_of_cotangents(Edge_index e) const;
  // The same by the unfolding alone: what is known of the flips before, as that a face is straight in space, is not
  // used.
  Sign sign_by_unfolding(Edge_index e) const;
  // The same on the way to a Delaunay triangulation: counts how the test was decided, and remembers what makes tests
  // after the next flips cheap. `corners` receives the two corners, unless both faces lie in one plane in space.
  Sign decide(Edge_index e, std::optional<Opposite_corners>& corners);
  // By which stage a test was decided, and how.
  struct Test
  {
    Stage stage;
    Sign sign;
  };
  enum class Effort {
    IN_PLANE,    // where both faces lie in one plane
    SHORT_STRIPS // and where few input edges cross those that are not straight
  };
  // The same by stages that never take long, for many tests while nothing is flipped. There is no answer where they do
  // not suffice.
  std::optional<Test> quick_test(Edge_index e, Effort effort) const;

  // Whether the two faces of `e` form a strictly convex quadrilateral. \pre `e` lies between two different faces
  bool is_convex(Edge_index e) const;
  // It is `NEGATIVE` only if some flip was made in a hinge that is not convex.
  Sign sign_of_area(Face_index f) const;
  bool has_length_zero(Edge_index e) const;
  // On which side of `h` a point of the input lies: `POSITIVE` to the left, `ZERO` on it.
  // \param h a halfedge that coincides with no input edge
  // \param position after how many crossings `h` runs through the input face of the point
  Sign side_of(Halfedge_index h, std::int64_t position, const Surface_point& point) const;

  // ---------------------------------------------------------------- numbers in the unit of the metric, with bounds

  // The corner opposite to h, and those at a vertex: for each face the side opposite to it, counterclockwise.
  // \pre h is not a border halfedge
  Corner corner(Halfedge_index h) const;
  std::vector<std::pair<Halfedge_index, Corner>> corners_at(Vertex_index v) const;
  // The same. What was laid out before is used, and what is laid out is kept, if edges at the vertex cross many input
  // edges.
  Corner kept_corner(Halfedge_index h);
  std::vector<std::pair<Halfedge_index, Corner>> kept_corners_at(Vertex_index v);
  // Whether a corner of the face of h was inserted into an input that is given by points.
  bool has_inserted_corner(Halfedge_index h) const;

  // ---------------------------------------------------------------- numbers in the unit of the input, rounded

  // Returns the length of `e` in the unit of the input, within one unit in the last
  // place.
  double length(Edge_index e) const;

  // Returns an interval around the length of `e`, in the unit of the input.
  Interval_nt<> length_interval(Edge_index e) const;

  // Returns the cotangent of the angle opposite to `h`, up to `2^-50 (1 + |cot|)`.
  // \pre `h` is not a border halfedge, its face has positive area
  double cotangent(Halfedge_index h) const;

  // Returns the angle opposite to `h`, up to a relative error of `2^-49` unless it is below `2^-400`. In a face of
  // zero area it is 0, or π rounded to `double`.
  // \pre `h` is not a border halfedge
  double angle(Halfedge_index h) const;

  // Returns the sum of the cotangents of the one or two angles opposite to `e`, up to
  // `2^-49` times one plus the sum of their absolute values. A sum of zero is exactly zero, and the sign is right.
  // \pre `e` lies in faces of positive area
  double cotangent_weight(Edge_index e) const;

  // Returns the area of `f` in the unit of the input, up to a relative error of `2^-50`.
  // A subnormal area is within two units in its last place, and not zero.
  // \exception Invalid_surface_error if the unit of the input is so small or so large that the area leaves the range of
  //   `double`
  double area(Face_index f) const;

  // Whether a face of the input has positive area.
  bool has_input_face_area(Face_index f) const;

  // Numbers of all elements, with one corner laid out for each face. NaN where that is not accurate enough to
  // be rounded as where each corner and edge is laid out.
  struct Rounded_numbers
  {
    explicit Rounded_numbers(const Delta_complex& complex);
    // As cotangent_weight() up to the last digits, or NaN. \pre e is no border edge
    double cotangent_weight(const Delta_complex& complex, Edge_index e) const;
    // As angle() up to this relative error, or NaN. \pre h is not a border halfedge
    double angle(Halfedge_index h, double relative_error) const;

    Large_vector<double> lengths; // as length() returns them, up to the last digit
    Large_vector<double> areas;   // in the unit of the metric
    // Opposite to each halfedge of a face: `hi()`, `lo()` and `error()`, which is infinite unless the area is known to
    // be positive.
    Large_vector<std::array<double, 3>> cotangents;
  };
  // Finds what belongs to faces from first to before last: any number of threads may do that for other faces.
  void find_numbers(std::size_t first, std::size_t last, Rounded_numbers& numbers) const;

  // The cotangents of the angles of a face: opposite to `halfedge(f)` and to the halfedges that follow.
  using Face_cotangents = std::array<Bounded_double_double, 3>;
  // Finds them with one corner laid out. The errors are infinite where the area is not known to be positive.
  void find_cotangents(Face_index f, Face_cotangents& result) const;
  // The same in doubles, in a fraction of the time. The errors are infinite for long strips, too.
  using Rounded_face_cotangents = std::array<Double_with_bound, 3>;
  void find_cotangents(Face_index f, Rounded_face_cotangents& result) const;
  // Likewise four times the area of a face, in the unit of the metric.
  Double_with_bound rounded_four_areas(Face_index f) const;

  // As `edge_beginning()` of `Unfolding`, with errors of at most 2^-50 of the vector, or of the source if that is
  // longer.
  struct Edge_beginning
  {
    std::complex<double> source, vector;
    Halfedge_index reference;
  };
  Edge_beginning edge_beginning(Halfedge_index h) const;

  // The angle at the source of an input halfedge, in its face, up to 2^-50. \pre `prepare()` was called, h is not a
  // border halfedge
  double input_angle(Halfedge_index h) const;

  // The input as the images of its metric see it; the caller's own as long as the lease lives. \pre `prepare()` was
  // called
  using Surface_lease = Scratch_pool<Input_surface>::Lease;
  Surface_lease input_surface() const;

private:
  std::unique_ptr<Input_surface> new_surface() const;

  struct Memory;
  using Image_corner = Triangle_corner<Residues>;

  // In flips for each edge: bounds the memory of the journal.
  static constexpr std::size_t longest_journal = 8;
  // In crossings of the four sides.
  static constexpr std::int64_t long_hinge = 4;
  // To carry a face along costs about as much as to lay out an eighth of a triangle, as most flips stay within one
  // plane.
  static constexpr double flips_for_a_quantity = 8;
  // In input quantities: what is laid out in some microseconds.
  static constexpr double short_strip = 256;

  bool flip_and_follow(const Hinge_halfedges& around);
  bool follow(const Hinge_halfedges& around);
  bool is_long_hinge(const Hinge_halfedges& around) const;
  bool is_prepared() const;
  void prepare(const Block_runner& run) const;
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
  std::optional<Test> test_in_plane(Halfedge_index h, Straight_faces& straight_faces) const;
  std::optional<Test> test_by_corners(Halfedge_index h, const Opposite_corners& corners) const;
  std::optional<Bounded_double_double> weight_by_other_diagonal(Halfedge_index h,
                                                                const Opposite_corners& corners) const;
  Corner known_corner(Halfedge_index h, Input_surface& surface) const;
  Opposite_corners known_corners(Halfedge_index h, Input_surface& surface) const;
  double number_of_quantities(Halfedge_index h) const;
  void carry_images();
  Known_corner<Corner, Image_corner> laid_out(Halfedge_index h, Input_surface& surface);
  Corner developed_corner(Halfedge_index h, Input_surface& surface);
  std::optional<Image_corner> image_of_straight_corner(Halfedge_index h);
  std::optional<Image_corner> image_of_developed_corner(Halfedge_index h) const;
  template <class FindImage>
  std::optional<Sign> sign_by_images(Edge_index e, const Opposite_corners& corners, Input_surface& surface,
                                     const FindImage& find_image) const;

  template <std::size_t N, class Evaluate>
  static std::array<std::complex<double>, N> rounded_vectors(Input_surface& surface, const Evaluate& evaluate);

  // As the public ones, with memory that the caller has taken.
  Sign sign_of_cotangents(Edge_index e, Input_surface& surface) const;
  Sign sign_of_area(Face_index f, Input_surface& surface) const;
  double cotangent(Halfedge_index h, const Corner& corner, Input_surface& surface) const;
  double signed_cotangent(Halfedge_index h, Input_surface& surface) const;
  Corner corner(Halfedge_index h, Input_surface& surface) const;
  Corner unfolded_corner(Halfedge_index h, Input_surface& surface) const;
  Bounded_double_double squared_length(Edge_index e, Input_surface& surface) const;
  Exact_fallback exact_fallback(Input_surface& surface) const;
  bool is_straight(Face_index f) const;
  void check_line(Edge_index e) const;
  // Whether the ends of the edges that h crosses lie on its two sides, or else on h, or else not so.
  enum class Line_check {
    STRAIGHT,
    TOUCHING,
    BENT
  };
  Line_check check_sides(Halfedge_index h, const Crossed_edges& crossed) const;
  Face_index plane(Face_index f) const;
  template <class Real>
  struct Side_and_corner;
  void find_angles(Face_index f, const Side_and_corner<Bounded_double_double>& at, Input_surface& surface,
                   Large_vector<double>& angles) const;
  bool are_sound(Face_index f, const Saved_triangulation& saved, const Side_and_corner<Bounded_double_double>& at,
                 Input_surface& surface) const;
  template <class Unfolding_>
  Side_and_corner<Bounded_double_double> quickest_corner(Face_index f, const Unfolding_& unfolding) const;
  std::optional<Side_and_corner<Double_with_bound>> rounded_corner(Face_index f) const;
  Corner straight_corner(Halfedge_index h) const;

  Delta_complex connectivity_;
  mutable Correspondence correspondence_; // prepared by the first query that needs it
  mutable std::atomic<bool> is_asked_{
    false}; // whether flips have to be followed, as a query was made since begin_journal()
  Input_metric metric_;
  std::unique_ptr<Memory> memory_; // null without an input
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_numbers_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_restore_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_signs_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_H
