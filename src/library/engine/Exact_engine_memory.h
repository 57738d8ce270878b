// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What an exact engine remembers of its input, of the flips, and of what was laid out.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
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

// What follows the flips, and what speeds up decisions.
//
// Const queries read it, and change it in three ways only, all of them safe: the pool of surfaces is made for that; the
// integers and the straight faces are brought up to date under the mutex, and an atomic flag tells the others that they
// are.
//
// Straight faces do not know of the flips in `journal`, nor of those in the journal of the correspondence but for the
// first `number_of_known_flips`. Flips that are not followed at once make what was developed of their faces wrong; it
// is forgotten at the latest when they leave one of these journals.
struct Exact_engine::Memory
{
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

  // At most one layout for each edge is spare, so that those that nobody asks for later never take long.
  void note_question(std::size_t number_of_edges)
  {
    spare_layouts = (std::min)(spare_layouts + layouts_for_question, number_of_edges);
  }

  Sign decided(const Test& test)
  {
    decisions.counts.add(test.stage, test.sign == ZERO);
    return test.sign;
  }

  template <class Edges>
  void forget_developed_faces(const Delta_complex& complex, const Edges& flips)
  {
    for (Edge_index e : flips) // faces that a flip has changed have an edge that was flipped
      for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
        developed_faces.forget(complex, h);
  }

  Correspondence correspondence;     // prepared by the first query that needs it
  std::atomic<bool> is_asked{false}; // flips have to be followed, as a query was made since begin_journal()

  Decisions decisions;
  std::vector<Edge_index> journal;
  std::size_t number_of_known_flips = 0;
  std::optional<Straight_faces> straight_faces;
  Vertex_positions::Inserted inserted_positions; // kept if the input has points
  Developed_faces developed_faces;
  std::optional<Developed_faces::Whole> split_face; // the last one, until its parts are measured
  std::vector<bool> is_close_call;                  // a test took more than double since the last flip of the edge
  std::size_t spare_layouts = 0;                    // so many flips may lay out faces

  std::unique_ptr<Carried_images> images; // of the developed faces, from the first tie on

  std::unique_ptr<Input_properties> input_properties; // made by the first thread that takes a surface
  std::mutex mutex;
  std::atomic<bool> is_prepared{false}, knows_straight_faces{false};
  Scratch_pool<Input_surface> surfaces;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_EXACT_ENGINE_MEMORY_H
