// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_geometry.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_IMPL_H

#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Coplanar_hinge.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Developed_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_sign.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Late_stages.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Sign_in_plane.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Straight_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Vertex_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/corner_signs.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/metric_images.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/area_in_input_unit.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace CGAL {
namespace Intrinsic_triangulations {

// What follows the flips, and what speeds up decisions.
//
// Const queries read it, and change it in three ways only, all of them safe: the pool of surfaces is made for that; the integers
// and the straight faces are found once, under the mutex, and an atomic flag tells the others that they are complete.
struct Exact_geometry::Memory
{
  using Developed_faces =
    internal::Developed_faces<internal::Bounded_double_double, internal::Double_double_disk, Corner, Image_corner>;

  struct Carried_images
  {
    explicit Carried_images(internal::Input_surface& surface)
      : rings(surface.prime_fields(0), surface.interruption(), 0), metric(surface, {rings})
    {}
    internal::Residue_rings rings; // without irrational roots
    internal::Residue_metric metric;
  };

  template <class Compute>
  std::optional<Image_corner> image(const Compute& compute) const
  {
    if (!images)
      return std::nullopt;
    try {
      const Image_corner result = compute();
      return images->rings.is_defined() ? std::make_optional(result) : std::nullopt;
    } catch (const internal::Too_costly&) {
      return std::nullopt;
    }
  }

  Sign decided(const Test& test)
  {
    counts.add(test.stage, test.sign == ZERO);
    return test.sign;
  }

  internal::Decision_settings settings;
  Stage_counts counts;
  std::vector<Edge_index> journal; // the flips until it was asked which faces are straight
  std::optional<internal::Straight_faces> straight_faces;
  internal::Vertex_positions::Inserted inserted_positions; // kept if the input has points
  Developed_faces developed_faces;
  std::vector<bool> is_close_call; // a test took more than double since the last flip of the edge

  std::unique_ptr<internal::Input_surface> surface_of_images;
  std::unique_ptr<Carried_images> images; // of the developed faces, from the first tie on

  std::mutex mutex;
  std::atomic<bool> is_prepared{false}, knows_straight_faces{false};
  internal::Scratch_pool<internal::Input_surface> surfaces;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Exact_geometry(Input_metric metric)
  : metric_(std::move(metric)), memory_(std::make_unique<Memory>())
{}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Exact_geometry(const Exact_geometry& other)
  : metric_(other.metric_), memory_(std::make_unique<Memory>())
{
  const std::lock_guard<std::mutex> lock(other.memory_->mutex);
  correspondence_ = other.correspondence_;
  is_asked_ = other.is_asked_.load();
  memory_->settings.tie_proof = other.memory_->settings.tie_proof;
  memory_->counts = other.memory_->counts;
  memory_->journal = other.memory_->journal;
  memory_->straight_faces = other.memory_->straight_faces;
  memory_->inserted_positions = other.memory_->inserted_positions;
  memory_->is_prepared = other.memory_->is_prepared.load();
  memory_->knows_straight_faces = other.memory_->knows_straight_faces.load();
}

// The surfaces refer to the members, which have moved.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Exact_geometry(Exact_geometry&& other) noexcept
  : correspondence_(std::move(other.correspondence_)), is_asked_(other.is_asked_.load()), metric_(std::move(other.metric_)),
    memory_(std::move(other.memory_))
{
  if (!memory_) // it was moved from before
    return;
  memory_->surfaces.clear();
  memory_->images.reset();
  memory_->surface_of_images.reset();
  memory_->developed_faces = {};
  memory_->is_close_call.clear();
  memory_->settings.interruption.exchange({});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry& Exact_geometry::operator=(Exact_geometry other) noexcept
{
  correspondence_ = std::move(other.correspondence_);
  is_asked_ = other.is_asked_.load();
  metric_ = std::move(other.metric_);
  memory_ = std::move(other.memory_);
  return *this;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::~Exact_geometry() = default;

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
const Stage_counts& Exact_geometry::stage_counts() const { return memory_->counts; }

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::set_tie_proof(Tie_proof tie_proof) { memory_->settings.tie_proof = tie_proof; }

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Tie_proof Exact_geometry::tie_proof() const { return memory_->settings.tie_proof; }

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::function<bool()> Exact_geometry::set_interruption(std::function<bool()> go_further)
{
  return memory_->settings.interruption.exchange(std::move(go_further));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
const internal::Interruption& Exact_geometry::interruption() const { return memory_->settings.interruption; }

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Surface_lease Exact_geometry::input_surface() const
{
  return memory_->surfaces.take(
    [this] { return new internal::Input_surface(correspondence_.input(), metric_, memory_->settings); });
}

// ---------------------------------------------------------------- once, when it is asked for

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::prepare(const Delta_complex& complex) const
{
  if (!memory_->is_prepared.load(std::memory_order_acquire))
    prepare(complex, internal::block_runner<Sequential_tag>());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::prepare(const Delta_complex& complex, const internal::Block_runner& run) const
{
  if (memory_->is_prepared.load(std::memory_order_acquire))
    return;
  const std::lock_guard<std::mutex> lock(memory_->mutex);
  if (memory_->is_prepared.load(std::memory_order_relaxed))
    return;
  std::vector<Edge_index> journal = correspondence_.prepare(complex, run);
  if (!memory_->straight_faces)
    memory_->journal = std::move(journal);
  is_asked_ = true;
  memory_->is_prepared.store(true, std::memory_order_release);
}

// Finds out which faces are straight, by repeating the flips; flip() keeps it up from then on.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::find_straight_faces(const Delta_complex& complex) const
{
  if (memory_->knows_straight_faces.load(std::memory_order_acquire))
    return;
  const std::lock_guard<std::mutex> lock(memory_->mutex);
  if (memory_->knows_straight_faces.load(std::memory_order_relaxed))
    return;
  internal::Straight_faces straight_faces(complex.number_of_faces(), metric_.points().size());
  std::vector<Edge_index> flips = correspondence_.journaled_flips(complex);
  flips.insert(flips.end(), memory_->journal.begin(), memory_->journal.end());
  if (!metric_.points().empty() && !flips.empty()) {
    Delta_complex copy = complex;
    for (std::size_t i = flips.size(); i-- > 0;)
      copy.flip_back(flips[i]);
    for (Edge_index e : flips) {
      straight_faces.flip(copy, positions(), e);
      copy.flip(e);
    }
  }
  memory_->straight_faces = std::move(straight_faces);
  std::vector<Edge_index>().swap(memory_->journal);
  is_asked_ = true;
  memory_->knows_straight_faces.store(true, std::memory_order_release);
}

// ---------------------------------------------------------------- following the flips

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::flip_and_follow(const Delta_complex& complex, const Hinge_halfedges& around)
{
  if (correspondence_.number_of_journaled_flips() + memory_->journal.size() >=
      longest_journal * std::size_t(complex.number_of_edges())) {
    find_straight_faces(complex);
    prepare(complex);
  }
  correspondence_.flip(complex, around);
  const Edge_index e = complex.edge(around.ij);
  if (memory_->straight_faces)
    return follow(complex, e);
  if (correspondence_.is_prepared())
    memory_->journal.push_back(e);
  return false;
}

// Keeps up what is known of the faces, before the flip of the connectivity. Returns whether
// the new faces are straight.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::follow(const Delta_complex& complex, Edge_index e)
{
  Memory& memory = *memory_;
  const bool is_close_call = !memory.is_close_call.empty() && memory.is_close_call[e.idx()];
  using Known_corner = Memory::Developed_faces::Known_corner;
  memory.developed_faces.flip(
    complex, e, is_close_call, [&](Halfedge_index h) -> std::optional<Known_corner> {
      if (!is_straight(complex.face(h)))
        return std::nullopt;
      return Known_corner{straight_corner(complex, h), image_of_straight_corner(complex, h)};
    });
  if (is_close_call)
    memory.is_close_call[e.idx()] = false;
  return memory.straight_faces->flip(complex, positions(), e);
}

// A face within one face of the input is straight, whatever the flips before.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::recognize_straight_face(const Delta_complex& complex, Halfedge_index h)
{
  const Face_index f = complex.face(h);
  if (is_straight(f) || metric_.points().empty())
    return;
  for (Halfedge_index side : {h, complex.next(h), complex.prev(h)})
    if (correspondence_.coordinates().crossings(complex.edge(side)) > 0)
      return;
  memory_->straight_faces->straighten(positions(), f, internal::uncrossed_input_face(complex, correspondence_, h));
}

// The journal of flips cannot be repeated beyond an insertion.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::split_face(const Delta_complex& complex, const Triangle_piece& piece, const Surface_point& location)
{
  find_straight_faces(complex);
  prepare(complex);
  correspondence_.split_face(complex, piece, location);
  split_faces(complex, {complex.face(piece.side)}, 3, 3, location);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location)
{
  find_straight_faces(complex);
  prepare(complex);
  correspondence_.split_edge(complex, h, location);
  std::vector<Face_index> faces;
  for (Halfedge_index side : {h, complex.opposite(h)})
    if (!complex.is_border(side))
      faces.push_back(complex.face(side));
  split_faces(complex, faces, 1 + faces.size(), 2, location);
}

// What is kept of faces that are split into parts; those beyond the first are appended, face by face.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::split_faces(const Delta_complex& complex, const std::vector<Face_index>& faces, std::size_t number_of_new_edges,
                                 std::size_t number_of_parts, const Surface_point& location)
{
  Memory& memory = *memory_;
  for (Face_index f : faces) {
    memory.straight_faces->split(positions(), f, number_of_parts - 1);
    memory.developed_faces.forget(f);
    memory.developed_faces.append(number_of_parts - 1);
  }
  if (!metric_.points().empty())
    memory.inserted_positions.push_back(positions().rounded(location));
  if (!memory.is_close_call.empty())
    memory.is_close_call.resize(complex.number_of_edges() + number_of_new_edges);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::unsplit_edge(const Delta_complex& complex, Halfedge_index h)
{
  correspondence_.unsplit_edge(complex, h);
  const Halfedge_index behind = complex.continuation(h);
  if (!complex.is_border(h))
    join_faces(complex.face(h), {complex.face(h), complex.face(behind)});
  if (!complex.is_border(complex.opposite(h)))
    join_faces(complex.face(complex.opposite(h)), {complex.face(complex.opposite(h)), complex.face(complex.opposite(behind))});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::unsplit_face(const Delta_complex& complex, Vertex_index v)
{
  const Halfedge_index a = complex.halfedge(v), b = complex.next_around_target(a), c = complex.next_around_target(b);
  const std::vector<Face_index> faces{complex.face(a), complex.face(b), complex.face(c)};
  // As in Delta_complex::unsplit_face(), the least one stays.
  join_faces(*std::min_element(faces.begin(), faces.end()), faces);
}

// A vertex was inserted, so that all faces are known.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::join_faces(Face_index f, const std::vector<Face_index>& faces)
{
  memory_->straight_faces->join(f, faces);
  memory_->developed_faces.forget(f);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::remove(const Delta_complex& complex, const Removed_elements& removed)
{
  correspondence_.remove(removed);
  Memory& memory = *memory_;
  memory.straight_faces->remove(removed.faces);
  memory.developed_faces.remove(complex, removed);
  if (!memory.is_close_call.empty())
    remove_entries(memory.is_close_call, removed.edges);
  if (!metric_.points().empty())
    remove_entries(memory.inserted_positions, removed.vertices, metric_.points().size());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
internal::Vertex_positions Exact_geometry::positions() const
{
  return {correspondence_.input(), metric_.points(), correspondence_.locations(), memory_->inserted_positions};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Image_corner> Exact_geometry::image_of_straight_corner(const Delta_complex& complex, Halfedge_index h)
{
  return memory_->image(
    [&] { return internal::image_of_straight_corner(complex, positions(), h, memory_->images->rings); });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Image_corner> Exact_geometry::image_of_developed_corner(const Delta_complex& complex,
                                                                                      Halfedge_index h) const
{
  return memory_->developed_faces.contains(complex.face(h)) ? memory_->developed_faces.image_of_corner(complex, h)
                                                            : std::nullopt;
}

// A tie seldom comes alone. From the first one on, images of corners in finite fields are carried along by the
// flips, where all areas are rational: this saves laying out strips of thousands of triangles for each tie.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::carry_images()
{
  memory_->surface_of_images =
    std::make_unique<internal::Input_surface>(correspondence_.input(), metric_, memory_->settings);
  memory_->images = std::make_unique<Memory::Carried_images>(*memory_->surface_of_images);
  memory_->developed_faces = {};
}

// As corner(), from what is kept of tests before.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::developed_corner(const Delta_complex& complex, Halfedge_index h,
                                                        internal::Input_surface& surface)
{
  Memory& memory = *memory_;
  const Face_index f = complex.face(h);
  if (is_straight(f))
    return straight_corner(complex, h);
  if (memory.developed_faces.contains(f))
    return memory.developed_faces.corner(complex, h);
  internal::Crossing_sequences sequences;
  internal::Double_double_metric metric(surface);
  const Corner c = Unfolding<internal::Double_double_metric>(complex, correspondence_, metric, sequences).opposite_corner(h);
  const auto image = memory.image([&] {
    return Unfolding<internal::Residue_metric>(complex, correspondence_, memory.images->metric, sequences)
      .opposite_corner(h);
  });
  memory.developed_faces.insert(complex, h, {c, image});
  return c;
}

// ---------------------------------------------------------------- signs

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::decide(const Delta_complex& complex, Edge_index e, std::optional<Opposite_corners>& corners)
{
  Memory& memory = *memory_;
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  find_straight_faces(complex);
  if (correspondence_.number_of_inserted_vertices() != 0) {
    recognize_straight_face(complex, h);
    recognize_straight_face(complex, g);
  }
  if (const std::optional<Test> test = test_in_plane(complex, h, *memory.straight_faces))
    return memory.decided(*test);
  prepare(complex);
  const Surface_lease surface = input_surface();
  memory.is_close_call.resize(complex.number_of_edges());
  memory.is_close_call[e.idx()] = true;
  corners = Opposite_corners{developed_corner(complex, h, *surface), developed_corner(complex, g, *surface)};
  // Layouts that were carried along are not the best, but what they do not decide is almost
  // always a tie.
  if (const std::optional<Test> test = test_by_corners(complex, h, *corners))
    return memory.decided(*test);
  const auto find_image = [&](Halfedge_index side) {
    return is_straight(complex.face(side)) ? image_of_straight_corner(complex, side) : image_of_developed_corner(complex, side);
  };
  if (const std::optional<Sign> tie = sign_by_images(complex, e, *corners, *surface, find_image))
    return memory.decided({Stage::MODULAR, *tie});
  const auto decision = late_stages(complex, *surface).sign_of_cotangents(internal::corners_beside(complex, e));
  if (decision.is_rational && !memory.images)
    carry_images();
  return memory.decided({decision.stage, decision.sign});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_inserted_corner(const Delta_complex& complex, Halfedge_index h) const
{
  return positions().has_inserted_corner(complex, h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::count(const Stage_counts& counts)
{
  memory_->counts += counts;
}

// \param straight_faces those of the memory; if they are const, nothing is remembered
template <class Straight_faces>
std::optional<Exact_geometry::Test> Exact_geometry::test_in_plane(const Delta_complex& complex, Halfedge_index h,
                                                                  Straight_faces& straight_faces) const
{
  const internal::Vertex_positions all = positions();
  if (!straight_faces.are_coplanar(complex, all, h))
    return std::nullopt;
  if (all.has_inserted_corner(complex, h) || all.has_inserted_corner(complex, complex.opposite(h)))
    return Test{Stage::COPLANAR, internal::Sign_in_plane(complex, all, h)()};
  return Test{Stage::COPLANAR, internal::Coplanar_hinge(complex, metric_.points(), h).sign_of_cotangents()};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_in_plane(const Delta_complex& complex, Edge_index e) const
{
  find_straight_faces(complex);
  const Memory& memory = *memory_;
  return test_in_plane(complex, complex.halfedge(e), *memory.straight_faces);
}

// From the corners beside h.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_by_corners(const Delta_complex& complex, Halfedge_index h,
                                                                    const Opposite_corners& corners) const
{
  const Halfedge_index g = complex.opposite(h);
  const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
  if (is_certain(sign))
    return Test{Stage::UNFOLDING, get_certain(sign)};
  if (is_straight(complex.face(h)) && is_straight(complex.face(g)))
    return Test{Stage::RATIONAL, internal::sign_of_cotangents(internal::rational_corner(complex, positions(), h),
                                                              internal::rational_corner(complex, positions(), g))};
  return std::nullopt;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_by_short_strips(const Delta_complex& complex, Edge_index e) const
{
  prepare(complex);
  find_straight_faces(complex);
  const Halfedge_index h = complex.halfedge(e);
  for (Halfedge_index side : {h, complex.opposite(h)})
    if (!is_straight(complex.face(side)) && number_of_quantities(complex, side) > short_strip)
      return std::nullopt;
  return test_by_corners(complex, h, known_corners(complex, h, *input_surface()));
}

// As `corner()` on both sides of h, from what is kept of tests before.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Opposite_corners Exact_geometry::known_corners(const Delta_complex& complex, Halfedge_index h,
                                                               internal::Input_surface& surface) const
{
  const auto known_corner = [&](Halfedge_index side) {
    const Face_index f = complex.face(side);
    return !is_straight(f) && memory_->developed_faces.contains(f) ? memory_->developed_faces.corner(complex, side)
                                                                   : corner(complex, side, surface);
  };
  return {known_corner(h), known_corner(complex.opposite(h))};
}

// A bound on the number of input quantities that the corner opposite to h is a function of.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
double Exact_geometry::number_of_quantities(const Delta_complex& complex, Halfedge_index h) const
{
  const Normal_coordinates& coordinates = correspondence_.coordinates();
  return double(coordinates.number_of_crossings(complex.edge(complex.next(h)))) +
         double(coordinates.number_of_crossings(complex.edge(complex.prev(h)))) +
         double(coordinates.triangle_crossings(complex, h).e_k) + 16;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_cotangents(const Delta_complex& complex, Edge_index e) const
{
  prepare(complex);
  find_straight_faces(complex);
  return sign_of_cotangents(complex, e, *input_surface());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_cotangents(const Delta_complex& complex, Edge_index e, internal::Input_surface& surface) const
{
  if (const std::optional<Test> test = test_in_plane(complex, e))
    return test->sign;
  const Halfedge_index h = complex.halfedge(e);
  const Opposite_corners corners = known_corners(complex, h, surface);
  if (const std::optional<Test> test = test_by_corners(complex, h, corners))
    return test->sign;
  // New images would be computed in rings that all threads share.
  const auto find_image = [&](Halfedge_index side) { return image_of_developed_corner(complex, side); };
  if (const std::optional<Sign> tie = sign_by_images(complex, e, corners, surface, find_image))
    return *tie;
  return late_stages(complex, surface).sign_of_cotangents(internal::corners_beside(complex, e)).sign;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_by_unfolding(const Delta_complex& complex, Edge_index e) const
{
  prepare(complex);
  const Surface_lease surface = input_surface();
  internal::Double_double_metric metric(*surface);
  const internal::Two_corners beside = internal::corners_beside(complex, e);
  const Opposite_corners corners = internal::unfolded_corners(
    Unfolding<internal::Double_double_metric>(complex, correspondence_, metric), beside);
  const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
  return is_certain(sign) ? get_certain(sign) : late_stages(complex, *surface).sign_of_cotangents(beside).sign;
}

// The sign of the sum of cotangents, if images that were carried along tell that the edge is a tie, or that both
// faces have no area.
template <class FindImage>
std::optional<Sign> Exact_geometry::sign_by_images(const Delta_complex& complex, Edge_index e,
                                                   const Opposite_corners& corners, internal::Input_surface& surface,
                                                   const FindImage& find_image) const
{
  const Memory& memory = *memory_;
  if (!memory.images || !surface.accepts_probable_ties())
    return std::nullopt;
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  const auto k = find_image(h), l = k ? find_image(g) : std::nullopt;
  if (!k || !l || !(k->p * l->four_areas + l->p * k->four_areas).is_zero() || !memory.images->rings.is_defined())
    return std::nullopt;
  const double number = number_of_quantities(complex, h) + number_of_quantities(complex, g);
  if (internal::Residue_rings::certainty(number, surface.largest_size(correspondence_.number_of_inserted_vertices() != 0)) < 128)
    return std::nullopt;
  const auto is_positive = [](const internal::Bounded_double_double& x) { return certainly(x.sign() == POSITIVE); };
  if (is_positive(corners.k.four_areas) && is_positive(corners.l.four_areas))
    return ZERO;
  const Uncertain<Sign> p_k = corners.k.p.sign(), p_l = corners.l.p.sign();
  if (k->four_areas.is_zero() && l->four_areas.is_zero() && is_certain(p_k) && is_certain(p_l))
    return internal::sign_of_tie(get_certain(p_k), get_certain(p_l));
  return std::nullopt;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::is_convex(const Delta_complex& complex, Edge_index e) const
{
  prepare(complex);
  find_straight_faces(complex);
  const Surface_lease surface = input_surface();
  // At both ends of e the two angles have to sum to less than π.
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  for (const internal::Two_corners& at_end :
       {internal::Two_corners{complex.next(h), complex.prev(g)},
        internal::Two_corners{complex.prev(h), complex.next(g)}}) {
    const Uncertain<Sign> sign = internal::sign_of_cotangents(corner(complex, at_end.opposite_to_k, *surface),
                                                              corner(complex, at_end.opposite_to_l, *surface));
    if ((is_certain(sign) ? get_certain(sign) : late_stages(complex, *surface).sign_of_cotangents(at_end).sign) !=
        POSITIVE)
      return false;
  }
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_area(const Delta_complex& complex, Face_index f) const
{
  prepare(complex);
  return sign_of_area(complex, f, *input_surface());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_input_face_area(Face_index f) const
{
  const Delta_complex& input = correspondence_.input();
  const Uncertain<Sign> sign = metric_.four_areas_double_double(input, f).sign();
  return is_certain(sign) ? get_certain(sign) != ZERO : squared_four_areas(metric_, input, f) != 0;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_area(const Delta_complex& complex, Face_index f, internal::Input_surface& surface) const
{
  const Halfedge_index h = complex.halfedge(f);
  const Uncertain<Sign> sign = unfolded_corner(complex, h, surface).four_areas.sign();
  return is_certain(sign) ? get_certain(sign) : late_stages(complex, surface).sign_of_area(h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_length_zero(const Delta_complex& complex, Edge_index e) const
{
  prepare(complex);
  const auto& developed_faces = memory_->developed_faces;
  for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
    if (!complex.is_border(h) && developed_faces.contains(complex.face(h)))
      if (certainly(developed_faces.corner(complex, h).s_opposite.sign() == POSITIVE))
        return false;
  const Surface_lease surface = input_surface();
  const internal::Bounded_double_double s = squared_length(complex, e, *surface);
  return is_certain(s.sign()) ? s.is_zero() : late_stages(complex, *surface).has_length_zero(e);
}

// Vectors that evaluate(metric) computes, each with an error of at most 2^-50 of its length, or of that of the last one if that is longer.
template <std::size_t N, class Evaluate>
std::array<std::complex<double>, N> Exact_geometry::rounded_vectors(internal::Input_surface& surface, const Evaluate& evaluate)
{
  constexpr long largest_precision = 1 << 14; // more is not needed unless a ratio of lengths leaves the range of double
  std::array<std::complex<double>, N> result;
  const auto is_narrow = [&](std::size_t i, double width) {
    return width <= 0x1p-51 * (std::max)(std::abs(result[i]), std::abs(result.back()));
  };
  {
    internal::Double_double_metric metric(surface);
    const auto vectors = evaluate(metric);
    bool is_good = true;
    for (std::size_t i = 0; i < N; ++i)
      result[i] = {vectors[i].x().hi(), vectors[i].y().hi()};
    for (std::size_t i = 0; i < N; ++i)
      is_good = is_good && is_narrow(i, vectors[i].x().error());
    if (is_good)
      return result;
  }
  for (long precision = 256;; precision *= 2) {
    internal::Mpfr_metric metric(surface, {precision});
    const auto vectors = evaluate(metric);
    std::array<double, N> width{};
    const auto middle = [](const internal::Mpfr_interval& x, double& largest_width) {
      const double low = x.lower_double(), high = x.upper_double();
      largest_width = (std::max)(largest_width, high - low);
      return low + (high - low) / 2;
    };
    for (std::size_t i = 0; i < N; ++i)
      result[i] = {middle(vectors[i].x(), width[i]), middle(vectors[i].y(), width[i])};
    bool is_good = true;
    for (std::size_t i = 0; i < N; ++i)
      is_good = is_good && is_narrow(i, width[i]);
    if (is_good || precision >= largest_precision)
      return result;
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Edge_beginning Exact_geometry::edge_beginning(const Delta_complex& complex, Halfedge_index h) const
{
  prepare(complex);
  Halfedge_index reference;
  const auto vectors = rounded_vectors<2>(*input_surface(), [&](auto& metric) {
    auto begin = Unfolding<std::decay_t<decltype(metric)>>(complex, correspondence_, metric).edge_beginning(h);
    reference = begin.reference;
    return std::array{begin.source, begin.vector};
  });
  return {vectors[0], vectors[1], reference};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
double Exact_geometry::input_angle(Halfedge_index h) const
{
  const auto side = rounded_vectors<1>(*input_surface(), [&](auto& metric) {
    return std::array{internal::Metric_frame<std::decay_t<decltype(metric)>>(correspondence_.input(), metric).ratios(h).at_source};
  });
  return std::atan2((std::max)(side[0].imag(), 0.), side[0].real());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::side_of(const Delta_complex& complex, Halfedge_index h, std::int64_t position, const Surface_point& point) const
{
  prepare(complex);
  const auto area_beside = [&](auto& metric) {
    return Unfolding<std::decay_t<decltype(metric)>>(complex, correspondence_, metric).area_beside(h, position, point);
  };
  return internal::exact_sign(*input_surface(), area_beside, [&] {
    return "that a point lies on edge " + std::to_string(complex.edge(h).idx());
  });
}

// ---------------------------------------------------------------- corners

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::corner(const Delta_complex& complex, Halfedge_index h) const
{
  prepare(complex);
  find_straight_faces(complex);
  return corner(complex, h, *input_surface());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<std::pair<Halfedge_index, Exact_geometry::Corner>> Exact_geometry::corners_at(const Delta_complex& complex, Vertex_index v) const
{
  prepare(complex);
  const Surface_lease surface = input_surface();
  internal::Double_double_metric metric(*surface);
  std::vector<std::pair<Halfedge_index, Corner>> result;
  Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).for_each_corner_at(v, [&](Halfedge_index h, const Corner& c) {
    result.emplace_back(h, c);
  });
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::corner(const Delta_complex& complex, Halfedge_index h,
                                              internal::Input_surface& surface) const
{
  return is_straight(complex.face(h)) ? straight_corner(complex, h) : unfolded_corner(complex, h, surface);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::unfolded_corner(const Delta_complex& complex, Halfedge_index h,
                                                       internal::Input_surface& surface) const
{
  internal::Double_double_metric metric(surface);
  return Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).opposite_corner(h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
internal::Bounded_double_double Exact_geometry::squared_length(const Delta_complex& complex, Edge_index e,
                                                               internal::Input_surface& surface) const
{
  internal::Double_double_metric metric(surface);
  return Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).squared_length(e);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
internal::Late_stages Exact_geometry::late_stages(const Delta_complex& complex, internal::Input_surface& surface) const
{
  return {complex, correspondence_, surface};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::is_straight(Face_index f) const { return (*memory_->straight_faces)(f); }

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::straight_corner(const Delta_complex& complex, Halfedge_index h) const
{
  return internal::straight_corner<Corner>(complex, positions(), h);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_geometry_numbers_impl.h>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_IMPL_H
