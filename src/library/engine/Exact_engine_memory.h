// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The memory of an exact engine: its input, the flips, and layouts.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include "history/Flip_log.h"
#include "Repeated_flips.h"
#include "layout/Developed_faces.h"
#include "layout/Straight_faces.h"
#include "layout/Vertex_positions.h"
#include "layout/metric_images.h"
#include "../arithmetic/Residues.h"
#include "../system/Scratch_pool.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// State that follows the flips, and caches for decisions.
//
// The log has two readers. One is the correspondence. The other consists of the straight faces and what goes with them:
// developed faces are right only as long as that reader follows.
//
// Const queries read all this, and change it in two ways only, both of them safe: the pool of surfaces is made for
// that; and a reader catches up with the log under the mutex, before the log tells the other threads so.
struct Exact_engine::Memory
{
  // How flips are repeated.
  enum class Answer {
    UNKNOWN,
    NO,
    LENGTHS,
    POSITIONS
  };

  struct Carried_images
  {
    explicit Carried_images(std::unique_ptr<Input_surface> own_surface)
      : surface(std::move(own_surface)), rings(surface->prime_fields(0), surface->interruption(), 0),
        metric(*surface, {rings})
    {}
    std::unique_ptr<Input_surface> surface;
    Residue_rings rings; // without irrational roots
    Residue_metric metric;
  };

  template <class Compute>
  std::optional<Image_corner> image(const Compute& compute) const
  {
    if (!images)
      return std::nullopt;
    try {
      const Image_corner result = compute();
      return images->rings.is_defined() ? std::make_optional(result) : std::nullopt;
    } catch (const Too_costly&) {
      return std::nullopt;
    }
  }

  // Caps the budget at one layout for each edge, so that unused layouts stay cheap.
  void note_question(std::size_t number_of_edges)
  {
    spare_layouts = (std::min)(spare_layouts + layouts_for_question, number_of_edges);
  }

  // Whether and how repeating all flips takes less time than laying out most faces: if there are many flips, unless
  // most faces are known to be straight, or if the edges cross much. Queries of several threads may ask this and must
  // agree: so it is decided once for each change.
  // \param prepare is called to make the integers follow
  template <class Prepare>
  Answer may_repeat_flips(const Delta_complex& complex, const Input_metric& metric, const Prepare& prepare)
  {
    if (log.is_followed_by(Flip_log::NUMBERS))
      return Answer::NO; // none is left to repeat
    Answer answer = repeats_flips.load(std::memory_order_acquire);
    if (answer != Answer::UNKNOWN)
      return answer;
    Answer found = 4 * log.number_of_unread(Flip_log::NUMBERS) >= 5 * std::size_t(complex.number_of_edges())
                     ? Answer::LENGTHS
                     : Answer::NO;
    if (found == Answer::LENGTHS && log.is_followed_by(Flip_log::FACES)) {
      const auto faces = complex.faces();
      if (2 * std::count_if(faces.begin(), faces.end(), [&](Face_index f) { return (*straight_faces)(f); }) >=
          std::ptrdiff_t(complex.number_of_faces()))
        found = Answer::NO;
    }
    if (found == Answer::NO && log.number_of_unread(Flip_log::NUMBERS) != 0)
      prepare(); // if flips are repeated, the integers may not be needed
    if (!metric.points().empty() && log.is_followed_by(Flip_log::INTEGERS)) {
      auto room = std::int64_t(4 * (complex.number_of_edges() + log.number_of_unread(Flip_log::NUMBERS)));
      for (Edge_index e : complex.edges())
        if ((room -= correspondence.coordinates().number_of_crossings(e)) < 0) {
          found = Answer::POSITIONS;
          break;
        }
    }
    return repeats_flips.compare_exchange_strong(answer, found) ? found : answer;
  }
  // The corner opposite to `halfedge(f)` by these flips, with at most this relative error.
  template <class Prepare>
  std::optional<Corner> corner_by_flips(const Delta_complex& complex, const Input_metric& metric,
                                        const Prepare& prepare, Face_index f, double relative_error)
  {
    const Answer answer = may_repeat_flips(complex, metric, prepare);
    if (answer == Answer::NO)
      return std::nullopt;
    const Repeated_flips* repeated = repeated_flips.load(std::memory_order_acquire);
    if (!repeated) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!own_repeated_flips)
        own_repeated_flips =
          answer == Answer::LENGTHS
            ? std::make_unique<Repeated_flips>(complex, log, metric, decisions.interruption)
            : std::make_unique<Repeated_flips>(complex, log, positions(metric), decisions.interruption);
      repeated_flips.store(repeated = own_repeated_flips.get(), std::memory_order_release);
    }
    return repeated->corner(complex, complex.halfedge(f), relative_error);
  }
  Vertex_positions positions(const Input_metric& metric) const
  {
    return {correspondence.input(), metric.points(), correspondence.locations(), inserted_positions};
  }
  // Whether close calls have laid out so much that it pays to carry all faces along from the first flip on.
  bool is_time_to_repeat_flips(const Delta_complex& complex, double number_of_quantities)
  {
    if (log.is_followed_by(Flip_log::NUMBERS))
      return false;
    laid_out_quantities += number_of_quantities;
    if (3 * laid_out_quantities < double(complex.number_of_edges() + 3 * log.number_of_unread(Flip_log::NUMBERS)))
      return false;
    laid_out_quantities *= -1; // the next time, twice as much
    return true;
  }
  void forget_repeated_flips()
  {
    if (repeats_flips.load(std::memory_order_relaxed) == Answer::UNKNOWN)
      return;
    repeats_flips = Answer::UNKNOWN;
    repeated_flips = nullptr;
    own_repeated_flips.reset();
  }

  void forget_developed_faces(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    developed_faces.forget(complex, around.ij);
    developed_faces.forget(complex, around.ji);
  }

  Flip_log log;
  Correspondence correspondence;

  Decisions decisions;
  std::optional<Straight_faces> straight_faces;
  Vertex_positions::Inserted inserted_positions; // kept if the input has points
  Developed_faces developed_faces;
  std::optional<Developed_faces::Whole> split_face; // the last one, until its parts are measured
  std::vector<bool> is_close_call;                  // a test took more than double since the last flip of the edge
  std::size_t spare_layouts = 0;                    // the number of flips that may lay out faces

  std::unique_ptr<Carried_images> images; // of the developed faces, from the first tie on

  std::atomic<Answer> repeats_flips = Answer::UNKNOWN; // since the last change, as are the next two
  std::atomic<const Repeated_flips*> repeated_flips = nullptr;
  std::unique_ptr<const Repeated_flips> own_repeated_flips;
  double laid_out_quantities = 0;

  std::unique_ptr<Input_properties> input_properties; // made by the first thread that takes a surface
  std::mutex mutex;
  Scratch_pool<Input_surface> surfaces;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H
