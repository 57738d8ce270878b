// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_engine: its memory, and how it follows flips.

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include "Exact_engine_memory.h"
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "history/Long_crossings.h"
#include "history/Flip_log.h"
#include "layout/Developed_faces.h"
#include "layout/Straight_faces.h"
#include "layout/Vertex_positions.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Exact_engine::Exact_engine(Delta_complex connectivity) : connectivity_(std::move(connectivity)) {}

void Exact_engine::keep_input(Input_metric metric)
{
  memory_ = std::make_unique<Memory>();
  metric_ = std::move(metric);
}

Exact_engine::Exact_engine(const Exact_engine& other) : connectivity_(other.connectivity_), metric_(other.metric_)
{
  if (!other.memory_)
    return;
  memory_ = std::make_unique<Memory>();
  const std::lock_guard<std::mutex> lock(other.memory_->mutex);
  memory_->log = other.memory_->log;
  memory_->correspondence = other.memory_->correspondence;
  memory_->decisions.tie_proof = other.memory_->decisions.tie_proof;
  memory_->decisions.counts = other.memory_->decisions.counts;
  memory_->straight_faces = other.memory_->straight_faces;
  memory_->inserted_positions = other.memory_->inserted_positions;
}

// The surfaces refer to the members, which have moved.
Exact_engine::Exact_engine(Exact_engine&& other) noexcept
  : connectivity_(std::move(other.connectivity_)), metric_(std::move(other.metric_)), memory_(std::move(other.memory_))
{
  if (!memory_)
    return;
  memory_->surfaces.clear();
  memory_->images.reset();
  memory_->input_properties.reset();
  memory_->developed_faces = {};
  memory_->split_face.reset();
  memory_->is_close_call.clear();
  memory_->decisions.interruption.exchange({});
}

Exact_engine& Exact_engine::operator=(Exact_engine other) noexcept
{
  connectivity_ = std::move(other.connectivity_);
  metric_ = std::move(other.metric_);
  memory_ = std::move(other.memory_);
  return *this;
}

Exact_engine::~Exact_engine() = default;

const Correspondence& Exact_engine::correspondence() const { return memory_->correspondence; }

Decisions& Exact_engine::decisions() { return memory_->decisions; }

const Decisions& Exact_engine::decisions() const { return memory_->decisions; }

Surface_lease Exact_engine::input_surface() const
{
  return memory_->surfaces.take([this] { return new_surface().release(); });
}

Surface_lease Exact_engine::surface_for_query() const
{
  prepare();
  Long_crossings all(connectivity_, correspondence(), decisions().interruption);
  if (correspondence().kept_crossings().is_time_for_all(connectivity_.number_of_edges(), [&] { return all.number(); }))
    all.keep();
  return input_surface();
}

// For a query that also uses straight faces.
Surface_lease Exact_engine::prepared_surface() const
{
  find_straight_faces();
  return surface_for_query();
}

// \pre `prepare()` was called
std::unique_ptr<Input_surface> Exact_engine::new_surface() const
{
  {
    const std::lock_guard<std::mutex> lock(memory_->mutex);
    if (!memory_->input_properties)
      memory_->input_properties = std::make_unique<Input_properties>(correspondence().input(), metric_);
  }
  return std::make_unique<Input_surface>(correspondence().input(), metric_, memory_->decisions,
                                         *memory_->input_properties);
}

// ---------------------------------------------------------------- what follows on request

void Exact_engine::begin_log()
{
  if (!memory_)
    return;
  memory_->log.begin();
  memory_->forget_repeated_flips();
}

const Flip_log& Exact_engine::log() const { return memory_->log; }

Exact_engine::Logs::Logs(Exact_engine& engine, std::size_t most) : engine_(engine)
{
  logs_.reserve(most);
  if (engine.memory_)
    engine.memory_->log.make_room(most);
}

// Flips of different logs commute as long as no other flip comes between: any order of them will do.
Exact_engine::Logs::~Logs()
{
  if (engine_.memory_)
    for (Log& log : logs_)
      engine_.memory_->log.append(std::move(log.flips_));
}

bool Exact_engine::is_prepared() const { return memory_->log.is_followed_by(Flip_log::INTEGERS); }

void Exact_engine::prepare(const Block_runner& run) const
{
  const std::lock_guard<std::mutex> lock(memory_->mutex);
  if (is_prepared())
    return;
  memory_->correspondence.catch_up(connectivity_, memory_->log, run);
  memory_->log.follow(Flip_log::INTEGERS);
}

// Determines which faces are straight by repeating the flips that were not followed, and forgets their earlier state.
void Exact_engine::find_straight_faces() const
{
  Memory& memory = *memory_;
  if (memory.log.is_followed_by(Flip_log::FACES))
    return;
  const std::lock_guard<std::mutex> lock(memory.mutex);
  const std::size_t number_of_flips = memory.log.number_of_unread(Flip_log::FACES);
  if (number_of_flips != 0 || !memory.straight_faces) {
    Straight_faces straight_faces = memory.straight_faces
                                      ? *memory.straight_faces
                                      : Straight_faces(connectivity_.number_of_faces(), metric_.points().size());
    if (!metric_.points().empty() && number_of_flips != 0)
      memory.log.repeat_unread(Flip_log::FACES, connectivity_,
                               [&](const Delta_complex& complex, const Hinge_halfedges& around) {
                                 straight_faces.flip(complex, positions(), complex.edge(around.ij));
                               });
    // A face that a flip has changed has an edge that was flipped.
    memory.log.for_each_unread(
      Flip_log::FACES, [&](const Hinge_halfedges& around) { memory.forget_developed_faces(connectivity_, around); });
    memory.straight_faces = std::move(straight_faces);
  }
  memory.log.follow(Flip_log::FACES);
}

// ---------------------------------------------------------------- following the flips

bool Exact_engine::log_or_follow(const Hinge_halfedges& around)
{
  memory_->forget_repeated_flips();
  Flip_log& log = memory_->log;
  if (log.size() >= longest_log * std::size_t(connectivity_.number_of_edges())) {
    log.follow(Flip_log::NUMBERS);
    find_straight_faces();
    prepare();
  }
  if (log.is_followed())
    return follow(around);
  log.push_back(around);
  return false;
}

// Updates the readers that follow; the others find the flip in the log.
bool Exact_engine::follow(const Hinge_halfedges& around)
{
  Memory& memory = *memory_;
  const bool has_integers = memory.log.is_followed_by(Flip_log::INTEGERS),
             has_faces = memory.log.is_followed_by(Flip_log::FACES);
  // Except for developed faces, knowledge of faces remains true without the flip. The integers come last.
  const bool are_straight = has_faces && follow_faces(around), is_logged = !memory.log.is_followed_by_all();
  if (is_logged)
    memory.log.push_back(around);
  try {
    if (has_integers)
      memory.correspondence.flip(connectivity_, around);
  } catch (...) {
    if (is_logged)
      memory.log.pop_back();
    memory.forget_developed_faces(connectivity_, around);
    throw;
  }
  return are_straight;
}

Exact_engine::Forgotten Exact_engine::forgotten_by_flip(const Hinge_halfedges& around) const
{
  if (memory_)
    find_straight_faces(); // otherwise later flips would lack the knowledge from before this one
  const Face_index f = connectivity_.face(around.ij), g = connectivity_.face(around.ji);
  return {
    {connectivity_.halfedge(f), connectivity_.halfedge(g)},
    {connectivity_.halfedge(connectivity_.source(around.ij)), connectivity_.halfedge(connectivity_.target(around.ij))},
    memory_ ? memory_->straight_faces->planes(f, g) : Straight_faces::no_planes};
}

void Exact_engine::flip_back(const Hinge_halfedges& around, const Forgotten& forgotten)
{
  if (memory_) {
    Memory& memory = *memory_;
    CGAL_precondition(memory.log.is_followed_by(Flip_log::FACES));
    memory.forget_developed_faces(connectivity_, around);
    memory.straight_faces->put_back(connectivity_.face(around.ij), connectivity_.face(around.ji), forgotten.planes);
    memory.forget_repeated_flips();
    if (is_prepared())
      memory.correspondence.flip_back(connectivity_, around);
    if (!memory.log.is_followed_by_all())
      memory.log.pop_back();
  }
  connectivity_.flip_back(around);
  set_first({forgotten.of_faces[0], forgotten.of_faces[1]});
  for (Halfedge_index h : forgotten.of_ends)
    connectivity_.set_halfedge(connectivity_.target(h), h);
}

void Exact_engine::set_first(std::initializer_list<Halfedge_index> first)
{
  for (Halfedge_index h : first)
    if (h.is_valid())
      connectivity_.set_halfedge(connectivity_.face(h), h);
}

// Maintains the knowledge about the faces, before the flip of the connectivity. Returns whether the new faces are
// straight.
bool Exact_engine::follow_faces(const Hinge_halfedges& around)
{
  Memory& memory = *memory_;
  const Edge_index e = connectivity_.edge(around.ij);
  const bool is_close_call = !memory.is_close_call.empty() && memory.is_close_call[e.idx()];
  if (Developed_faces& faces = memory.developed_faces; !faces.flip_in_plane(around)) {
    // If faces are requested often, laying one out later, for its successors, would take longer. Images in finite
    // fields are so slow that they are carried only for close calls.
    const bool lays_out = memory.spare_layouts > 0 && is_prepared() && !memory.images &&
                          !(is_straight(connectivity_.face(around.ij)) && is_straight(connectivity_.face(around.ji)));
    memory.spare_layouts -= lays_out;
    if (lays_out || (is_close_call && (memory.spare_layouts > 0 || memory.images)) || faces.contains(around.ij) ||
        faces.contains(around.ji))
      faces.flip(connectivity_, around, [&](Halfedge_index h) -> std::optional<Known_corner> {
        if (is_straight(connectivity_.face(h)))
          return Known_corner{h, straight_corner(h), image_of_straight_corner(h)};
        if (!lays_out)
          return std::nullopt;
        return laid_out(correspondence().coordinates().side_with_most_crossings(connectivity_, connectivity_.face(h)));
      });
  }
  if (is_close_call)
    memory.is_close_call[e.idx()] = false;
  return memory.straight_faces->flip(connectivity_, positions(), e, is_close_call);
}

// A face within one face of the input is straight, whichever flips led to it.
void Exact_engine::recognize_straight_face(Halfedge_index h)
{
  const Face_index f = connectivity_.face(h);
  if (is_straight(f) || metric_.points().empty())
    return;
  for (Halfedge_index side : {h, connectivity_.next(h), connectivity_.prev(h)})
    if (correspondence().coordinates().crossings(connectivity_.edge(side)) > 0)
      return;
  memory_->straight_faces->straighten(positions(), f, uncrossed_input_face(connectivity_, correspondence(), h));
}

// The flips in the log cannot be repeated beyond an insertion, and input edges are followed faster before it.
void Exact_engine::prepare_insertion()
{
  find_straight_faces();
  prepare();
  memory_->log.follow(Flip_log::NUMBERS);
  if (correspondence().number_of_inserted_vertices() == 0 || correspondence().kept_crossings().is_empty())
    keep_crossings();
}

void Exact_engine::keep_crossings() const
{
  Long_crossings(connectivity_, correspondence(), decisions().interruption).keep();
}

Halfedge_index Exact_engine::halfedge_of_face(const Triangle_piece& piece) const
{
  return connectivity_.halfedge(connectivity_.face(piece.side));
}

Vertex_index Exact_engine::split_face(const Triangle_piece& piece, const Surface_point& location)
{
  prepare_insertion();
  connectivity_.make_room_for_vertex();
  const Face_index f = connectivity_.face(piece.side);
  memory_->split_face.reset();
  const Developed_faces& developed = memory_->developed_faces;
  const auto whole =
    developed.contains(piece.side) ? std::make_optional(developed.whole(connectivity_, piece.side)) : std::nullopt;
  split_faces({f}, 3, 3, location, [&] { memory_->correspondence.split_face(connectivity_, piece, location); });
  memory_->split_face = whole; // a failed split leaves nothing behind
  return connectivity_.split_face(piece.side);
}

Vertex_index Exact_engine::split_edge(Halfedge_index h, const Surface_point& location)
{
  prepare_insertion();
  connectivity_.make_room_for_vertex();
  memory_->split_face.reset();
  std::vector<Face_index> faces;
  for (Halfedge_index side : {h, connectivity_.opposite(h)})
    if (!connectivity_.is_border(side))
      faces.push_back(connectivity_.face(side));
  split_faces(faces, 1 + faces.size(), 2, location,
              [&] { memory_->correspondence.split_edge(connectivity_, h, location); });
  return connectivity_.split_edge(h);
}

// Updates the data of faces that are split into parts; parts beyond the first are appended, face by face.
// \param split_integers splits the faces in the correspondence. An exception leaves everything unchanged
template <class SplitIntegers>
void Exact_engine::split_faces(const std::vector<Face_index>& faces, std::size_t number_of_new_edges,
                               std::size_t number_of_parts, const Surface_point& location,
                               const SplitIntegers& split_integers)
{
  Memory& memory = *memory_;
  const bool has_points = !metric_.points().empty();
  const auto position = has_points ? std::make_optional(positions().rounded(location)) : std::nullopt;
  const std::size_t number_of_new_faces = faces.size() * (number_of_parts - 1);
  for (Face_index f : faces)
    memory.straight_faces->prepare_split(positions(), f, number_of_new_faces);
  memory.developed_faces.make_room(number_of_new_edges);
  make_room(memory.inserted_positions, 1);
  make_room(memory.is_close_call, number_of_new_edges);
  split_integers();
  for (Face_index f : faces) {
    memory.straight_faces->split(f, number_of_parts - 1);
    memory.developed_faces.forget(connectivity_, connectivity_.halfedge(f));
  }
  memory.developed_faces.append(number_of_new_edges);
  if (has_points)
    memory.inserted_positions.push_back(*position);
  if (!memory.is_close_call.empty())
    memory.is_close_call.resize(connectivity_.number_of_edges() + number_of_new_edges);
}

Removed_elements Exact_engine::unsplit_edge(Halfedge_index h, std::initializer_list<Halfedge_index> first)
{
  memory_->correspondence.unsplit_edge(connectivity_, h);
  const Halfedge_index behind = connectivity_.continuation(h), g = connectivity_.opposite(h);
  for (const auto& [one, other] : {std::pair(h, behind), std::pair(g, connectivity_.opposite(behind))})
    if (!connectivity_.is_border(one))
      join_faces(connectivity_.face(one), {connectivity_.face(one), connectivity_.face(other)});
  const Removed_elements removed = connectivity_.unsplit_edge(h);
  remove(removed);
  set_first(first);
  return removed;
}

Removed_elements Exact_engine::unsplit_face(Vertex_index v, std::initializer_list<Halfedge_index> first)
{
  const Halfedge_index a = connectivity_.halfedge(v), b = connectivity_.next_around_target(a),
                       c = connectivity_.next_around_target(b);
  const std::initializer_list<Face_index> faces{connectivity_.face(a), connectivity_.face(b), connectivity_.face(c)};
  // As in Delta_complex::unsplit_face(), the smallest one stays.
  join_faces((std::min)(faces), faces);
  const Removed_elements removed = connectivity_.unsplit_face(v);
  remove(removed);
  set_first(first);
  return removed;
}

// A vertex was inserted, so all faces are known.
void Exact_engine::join_faces(Face_index f, std::initializer_list<Face_index> faces)
{
  memory_->straight_faces->join(f, faces);
  for (Face_index each : faces)
    memory_->developed_faces.forget(connectivity_, connectivity_.halfedge(each));
}

// After the removal from the connectivity. Never throws.
void Exact_engine::remove(const Removed_elements& removed)
{
  memory_->correspondence.remove(removed);
  Memory& memory = *memory_;
  memory.straight_faces->remove(removed.faces);
  memory.developed_faces.remove(removed.edges);
  if (!memory.is_close_call.empty())
    remove_entries(memory.is_close_call, removed.edges);
  if (!metric_.points().empty())
    remove_entries(memory.inserted_positions, removed.vertices, metric_.points().size());
}

// ---------------------------------------------------------------- where the input lies

const Delta_complex& input(const Correspondence& correspondence) { return correspondence.input(); }

std::int64_t crossings(const Correspondence& correspondence, Edge_index e)
{
  return correspondence.coordinates().crossings(e);
}

Halfedge_index input_halfedge(const Correspondence& correspondence, Halfedge_index h)
{
  return correspondence.input_halfedge(h);
}

bool is_inserted(const Correspondence& correspondence, Vertex_index v) { return correspondence.is_inserted(v); }

const Surface_point& location(const Correspondence& correspondence, Vertex_index v)
{
  return correspondence.location(v);
}

Halfedge_index quickest_side(const Exact_engine& engine, Face_index f)
{
  return engine.correspondence().coordinates().side_with_most_crossings(engine.connectivity(), f);
}

} // namespace CGAL::Intrinsic_triangulations::internal
