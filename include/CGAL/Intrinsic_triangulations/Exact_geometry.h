// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact decisions and trustworthy numbers from the input and the integers alone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Stage_counts.h>
#include <CGAL/Intrinsic_triangulations/Tie_proof.h>
#include <CGAL/Intrinsic_triangulations/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Block_runner.h>
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
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {
class Input_surface;
class Interruption;
class Exact_fallback;
class Residues;
class Vertex_positions;
template <class Corner, class Image_corner>
struct Known_corner;
} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief the exact geometry of a current triangulation: the metric of the input, and
/// where the input lies in the current triangulation.
///
/// Every answer is a function of the input and of the connectivity and does not depend on
/// the flips that led there. All const member functions may be called by several threads at once: each works with
/// memory of its own, and the first one that needs the integers computes them while the others wait.
class Exact_geometry
{
public:
  /// \cond SKIP_IN_MANUAL
  // A corner in double-doubles with error bounds.
  using Corner = Triangle_corner<internal::Bounded_double_double>;
  // The corners opposite to an edge, k to its left and l to its right.
  using Opposite_corners = Intrinsic_triangulations::Opposite_corners<internal::Bounded_double_double>;
  /// \endcond

  /// constructs the geometry of a triangulation that has not been flipped yet.
  explicit Exact_geometry(Input_metric metric);

  /// \name Copies
  /// What only speeds up queries is not copied.
  /// @{

  /// copies, moves or assigns the geometry.
  Exact_geometry(const Exact_geometry& other);
  Exact_geometry(Exact_geometry&& other) noexcept;
  Exact_geometry& operator=(Exact_geometry other) noexcept;
  ~Exact_geometry();
  /// @}

  /// returns where the input lies in the current triangulation.
  /// \pre `prepare()` was called, and not `flip_to_Delaunay()` since
  const Correspondence& correspondence() const { return correspondence_; }
  /// returns the metric of the input.
  const Input_metric& metric() const { return metric_; }
  /// returns how the tests that reached the exact stages were decided.
  const Stage_counts& stage_counts() const;

  /// \name Changes
  /// An exception leaves everything as it was, as far as answers can tell.
  /// @{

  /// \brief follows a flip, before that of the connectivity.
  ///
  /// \param complex the triangulation
  /// \param around the halfedges around the edge
  /// \return whether the new edge is known to be a straight line between two of the points
  /// \exception Integer_overflow_error as `prepare()` and `flip()` of `Correspondence`
  bool flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (is_asked_.load(std::memory_order_relaxed) || correspondence_.number_of_journaled_flips() >= longest_journal * std::size_t(complex.number_of_edges()))
      return flip_and_follow(complex, around);
    correspondence_.flip(complex, around);
    return false;
  }
  /// \cond SKIP_IN_MANUAL
  // Undoes a flip, the last one that was not undone, before that is done in the connectivity. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Delta_complex& complex, Hinge_halfedges around);
  // So many calls of append() do not throw then.
  void make_room_for_journals(std::size_t number) { correspondence_.make_room_for_journals(number); }
  /// \endcond
  /// \brief logs flips from now on until the next query, so that each takes the least time.
  ///
  /// `flip_to_Delaunay()` begins with this. For the flips of other functions, which are few and between queries, the integers are kept up
  /// to date once they were asked for. O(1).
  void begin_journal();
  /// as `append()` of `Correspondence`. \pre no query was made since `begin_journal()`
  void append(std::vector<Hinge_halfedges> flips) { correspondence_.append(std::move(flips)); }

  /// \brief follows the insertion of a vertex, before that of the connectivity; as the functions of `Correspondence`
  /// with the same names.
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  void split_face(const Delta_complex& complex, const Triangle_piece& piece, const Surface_point& location);
  /// as above.
  void split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location);

  /// \brief follows the join of two edges, before that of the connectivity; as the function of `Correspondence`.
  void unsplit_edge(const Delta_complex& complex, Halfedge_index h);
  /// \brief follows the join of three faces, before that of the connectivity. Never throws.
  void unsplit_face(const Delta_complex& complex, Vertex_index v);
  /// \brief follows the removal of an inserted vertex, after that of the connectivity. Never throws.
  /// \param complex the connectivity after the removal
  /// \param removed what was removed
  void remove(const Delta_complex& complex, const Removed_elements& removed);

  /// \brief sets what decisions accept as a tie from now on.
  void set_tie_proof(Tie_proof tie_proof);
  /// returns what decisions accept as a tie.
  Tie_proof tie_proof() const;

  /// \brief sets a function that is called from time to time during a single decision that takes
  /// long: if it returns `false`, the decision ends with a `Cancelled_error`, and nothing is changed.
  ///
  /// An empty function, as at the beginning, never ends one. Copies do not take it over. It is called by
  /// the threads that make the decisions, by several at once if they do.
  /// \return the function that was set before
  std::function<bool()> set_interruption(std::function<bool()> go_further);

  /// \cond SKIP_IN_MANUAL
  // As `sign_of_cotangents()`, on the way to a Delaunay triangulation: counts how the test was decided, and remembers
  // what makes tests after the next flips cheap. `corners` receives the two corners, unless both faces lie in one plane in
  // space.
  Sign decide(const Delta_complex& complex, Edge_index e, std::optional<Opposite_corners>& corners);
  // As `corner()`, and as `corners_at()`. What was laid out before is used, and what is laid out is kept, if edges at the vertex cross many input edges.
  Corner kept_corner(const Delta_complex& complex, Halfedge_index h);
  std::vector<std::pair<Halfedge_index, Corner>> kept_corners_at(const Delta_complex& complex, Vertex_index v);
  // Adds tests that others have counted.
  void count(const Stage_counts& counts);
  /// \endcond
  /// @}

  /// \name Queries
  /// Each begins with `prepare()`.
  /// @{

  /// \brief computes the integers and recovers the input, where that was not done yet; all queries do so themselves.
  /// O(size + number of flips) if there is a journal of flips, and O(1) otherwise.
  /// \exception Integer_overflow_error as `prepare()` of `Correspondence`
  void prepare(const Delta_complex& complex) const;
  /// \brief as above: with threads, the integers are computed while the input is recovered.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the result is the same
  template <class ConcurrencyTag>
  void prepare(const Delta_complex& complex) const
  {
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
      prepare(complex, internal::block_runner<ConcurrencyTag>());
    else
      prepare(complex);
  }
  /// \cond SKIP_IN_MANUAL
  // As above, with the threads of a loop.
  void prepare(const Delta_complex& complex, const internal::Block_runner& run) const;
  /// \endcond

  /// \brief returns the sign of `cot k + cot l` for the angles opposite to `e`, exactly.
  ///
  /// Where both faces have zero area, it is `NEGATIVE` if both angles are π, and `ZERO`
  /// otherwise.
  /// \pre `e` lies between two different faces
  /// \exception Undecided_error if a proof is demanded of each tie, and takes too long
  /// \exception Cancelled_error if the function that was given to `set_interruption()` says so
  Sign sign_of_cotangents(const Delta_complex& complex, Edge_index e) const;

  /// \cond SKIP_IN_MANUAL
  // By which stage a test was decided, and how.
  struct Test
  {
    Stage stage;
    Sign sign;
  };
  // Those of the stages of `sign_of_cotangents()` that never take long, for many tests while nothing is flipped: where both faces lie
  // in one plane, ...
  std::optional<Test> test_in_plane(const Delta_complex& complex, Edge_index e) const;
  // ... and where few input edges cross those that are not straight. There is no answer where they do not suffice.
  std::optional<Test> test_by_short_strips(const Delta_complex& complex, Edge_index e) const;
  /// \endcond

  /// \brief as above, but by the unfolding alone: what is known of the flips before, as
  /// that a face is straight in space, is not used.
  Sign sign_by_unfolding(const Delta_complex& complex, Edge_index e) const;

  /// \brief returns whether the two faces of `e` form a strictly convex quadrilateral.
  /// \pre `e` lies between two different faces
  /// \exception Undecided_error as `sign_of_cotangents()`
  bool is_convex(const Delta_complex& complex, Edge_index e) const;

  /// returns the sign of the area of `f`, laid out over the input. It is `NEGATIVE` only if
  /// some flip was made in a hinge that is not convex.
  Sign sign_of_area(const Delta_complex& complex, Face_index f) const;

  /// returns whether a face of the input has positive area.
  bool has_input_face_area(Face_index f) const;

  /// returns the length of `e` in the unit of the input, within one unit in the last
  /// place.
  double length(const Delta_complex& complex, Edge_index e) const;

  /// returns an interval around the length of `e`, in the unit of the input.
  Interval_nt<> length_interval(const Delta_complex& complex, Edge_index e) const;

  /// returns the cotangent of the angle opposite to `h`, up to `2^-50 (1 + |cot|)`.
  /// \pre `h` is not a border halfedge, its face has positive area
  double cotangent(const Delta_complex& complex, Halfedge_index h) const;

  /// returns the angle opposite to `h`, up to a relative error of `2^-49` unless it is below `2^-400`. In a face of
  /// zero area it is 0, or π rounded to `double`.
  /// \pre `h` is not a border halfedge
  double angle(const Delta_complex& complex, Halfedge_index h) const;

  /// returns the sum of the cotangents of the one or two angles opposite to `e`, up to
  /// `2^-49` times one plus the sum of their absolute values. A sum of zero is exactly zero, and the sign is right.
  /// \pre `e` lies in faces of positive area
  double cotangent_weight(const Delta_complex& complex, Edge_index e) const;

  /// returns the area of `f` in the unit of the input, up to a relative error of `2^-50`.
  /// A subnormal area is within two units in its last place, and not zero.
  /// \exception Invalid_surface_error if the unit of the input is so small or so large that the area leaves the range of `double`
  double area(const Delta_complex& complex, Face_index f) const;

  /// returns whether two vertices coincide: whether `e` has length zero.
  bool has_length_zero(const Delta_complex& complex, Edge_index e) const;

  /// @}

  /// \brief returns on which side of `h` a point of the input lies: `POSITIVE` to the left, `ZERO` on it.
  ///
  /// \param complex the triangulation
  /// \param h a halfedge that coincides with no input edge
  /// \param position after how many crossings `h` runs through the input face of the point
  /// \param point the point; its coordinates are taken as exact once they are divided by their sum
  /// \exception Undecided_error as `sign_of_cotangents()`
  Sign side_of(const Delta_complex& complex, Halfedge_index h, std::int64_t position, const Surface_point& point) const;

  /// \cond SKIP_IN_MANUAL
  // The corner opposite to h, in the unit of the metric. \pre h is not a border halfedge
  Corner corner(const Delta_complex& complex, Halfedge_index h) const;
  // The corners at a vertex that was just inserted, in the unit of the metric: for each face that side which is opposite to it,
  // counterclockwise.
  std::vector<std::pair<Halfedge_index, Corner>> corners_at(const Delta_complex& complex, Vertex_index v) const;

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
    // Opposite to each halfedge of a face: `hi()`, `lo()` and `error()`, which is infinite unless the area is known to be positive.
    Large_vector<std::array<double, 3>> cotangents;
  };
  // Finds what belongs to faces from first to before last: any number of threads may do that for other faces.
  void find_numbers(const Delta_complex& complex, std::size_t first, std::size_t last, Rounded_numbers& numbers) const;

  // The cotangents of the angles of a face: opposite to `halfedge(f)` and to the halfedges that follow.
  using Face_cotangents = std::array<internal::Bounded_double_double, 3>;
  // Finds them with one corner laid out. The errors are infinite where the area is not known to be positive.
  void find_cotangents(const Delta_complex& complex, Face_index f, Face_cotangents& result) const;
  // The same in doubles, in a fraction of the time. The errors are infinite for long strips, too.
  using Rounded_face_cotangents = std::array<internal::Double_with_bound, 3>;
  void find_cotangents(const Delta_complex& complex, Face_index f, Rounded_face_cotangents& result) const;
  // Likewise four times the area of a face, in the unit of the metric.
  internal::Double_with_bound rounded_four_areas(const Delta_complex& complex, Face_index f) const;

  // Whether a corner of the face of h was inserted into an input that is given by points.
  bool has_inserted_corner(const Delta_complex& complex, Halfedge_index h) const;

  // For work that makes many short decisions.
  const internal::Interruption& interruption() const;

  // As `edge_beginning()` of `Unfolding`, with errors of at most 2^-50 of the vector, or of the source if that is longer.
  struct Edge_beginning
  {
    std::complex<double> source, vector;
    Halfedge_index reference;
  };
  Edge_beginning edge_beginning(const Delta_complex& complex, Halfedge_index h) const;

  // The angle at the source of an input halfedge, in its face, up to 2^-50. \pre `prepare()` was called, h is not a border halfedge
  double input_angle(Halfedge_index h) const;

  // The input as the images of its metric see it; the caller's own as long as the lease lives. \pre `prepare()` was called
  using Surface_lease = internal::Scratch_pool<internal::Input_surface>::Lease;
  Surface_lease input_surface() const;
  /// \endcond

private:
  std::unique_ptr<internal::Input_surface> new_surface() const;

  struct Memory;
  using Image_corner = Triangle_corner<internal::Residues>;

  // In flips for each edge: bounds the memory of the journal.
  static constexpr std::size_t longest_journal = 8;
  // In crossings of the four sides.
  static constexpr std::int64_t long_hinge = 4;
  // To carry a face along costs about as much as to lay out an eighth of a triangle, as most flips stay within one plane.
  static constexpr double flips_for_a_quantity = 8;
  // In input quantities: what is laid out in some microseconds.
  static constexpr double short_strip = 256;

  bool flip_and_follow(const Delta_complex& complex, const Hinge_halfedges& around);
  bool follow(const Delta_complex& complex, const Hinge_halfedges& around);
  bool is_long_hinge(const Delta_complex& complex, const Hinge_halfedges& around) const;
  void find_straight_faces(const Delta_complex& complex) const;
  void recognize_straight_face(const Delta_complex& complex, Halfedge_index h);
  void prepare_insertion(const Delta_complex& complex);
  template <class SplitIntegers>
  void split_faces(const Delta_complex& complex, const std::vector<Face_index>& faces, std::size_t number_of_new_edges, std::size_t number_of_parts,
                   const Surface_point& location, const SplitIntegers& split_integers);
  void join_faces(Face_index f, std::initializer_list<Face_index> faces);
  internal::Vertex_positions positions() const;
  template <class Straight_faces>
  std::optional<Test> test_in_plane(const Delta_complex& complex, Halfedge_index h, Straight_faces& straight_faces) const;
  std::optional<Test> test_by_corners(const Delta_complex& complex, Halfedge_index h, const Opposite_corners& corners) const;
  std::optional<internal::Bounded_double_double> weight_by_other_diagonal(const Delta_complex& complex, Halfedge_index h,
                                                                          const Opposite_corners& corners) const;
  Corner known_corner(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const;
  Opposite_corners known_corners(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const;
  double number_of_quantities(const Delta_complex& complex, Halfedge_index h) const;
  void carry_images();
  internal::Known_corner<Corner, Image_corner> laid_out(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface);
  Corner developed_corner(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface);
  std::optional<Image_corner> image_of_straight_corner(const Delta_complex& complex, Halfedge_index h);
  std::optional<Image_corner> image_of_developed_corner(const Delta_complex& complex, Halfedge_index h) const;
  template <class FindImage>
  std::optional<Sign> sign_by_images(const Delta_complex& complex, Edge_index e, const Opposite_corners& corners,
                                     internal::Input_surface& surface, const FindImage& find_image) const;

  template <std::size_t N, class Evaluate>
  static std::array<std::complex<double>, N> rounded_vectors(internal::Input_surface& surface, const Evaluate& evaluate);

  // As the public ones, with memory that the caller has taken.
  Sign sign_of_cotangents(const Delta_complex& complex, Edge_index e, internal::Input_surface& surface) const;
  Sign sign_of_area(const Delta_complex& complex, Face_index f, internal::Input_surface& surface) const;
  double cotangent(const Delta_complex& complex, Halfedge_index h, const Corner& corner, internal::Input_surface& surface) const;
  double signed_cotangent(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const;
  Corner corner(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const;
  Corner unfolded_corner(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const;
  internal::Bounded_double_double squared_length(const Delta_complex& complex, Edge_index e,
                                                 internal::Input_surface& surface) const;
  internal::Exact_fallback exact_fallback(const Delta_complex& complex, internal::Input_surface& surface) const;
  bool is_straight(Face_index f) const;
  template <class Real>
  struct Side_and_corner;
  template <class Unfolding_>
  Side_and_corner<internal::Bounded_double_double> quickest_corner(const Delta_complex& complex, Face_index f, const Unfolding_& unfolding) const;
  std::optional<Side_and_corner<internal::Double_with_bound>> rounded_corner(const Delta_complex& complex, Face_index f) const;
  Corner straight_corner(const Delta_complex& complex, Halfedge_index h) const;

  mutable Correspondence correspondence_;     // prepared by the first query that needs it
  mutable std::atomic<bool> is_asked_{false}; // whether flips have to be followed, as a query was made since begin_journal()
  Input_metric metric_;
  std::unique_ptr<Memory> memory_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_geometry_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H
