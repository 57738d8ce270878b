// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The lengths that a wave stands for, and the wave of a window.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_FUNCTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_FUNCTIONS_H

#include "Window.h"
#include "plane_vectors.h"

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Wave.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

inline double distance_in_plane(const plane::Vector& p, const plane::Vector& q)
{
  return length_of(p[0] - q[0], p[1] - q[1]);
}

inline double distance_to_segment(const Wave& wave, const plane::Vector& p)
{
  const plane::Vector along = plane::difference(wave.ends[1], wave.ends[0]), way = plane::difference(p, wave.ends[0]);
  const double length = length_of(along[0], along[1]), at = plane::dot(along, way) / length;
  return at > length ? distance_in_plane(p, wave.ends[1])
         : at > 0    ? std::abs(plane::cross(along, way)) / length
                     : length_of(way[0], way[1]);
}

// The length of the ways of a wave to a point of its face.
inline double distance(const Wave& wave, const plane::Vector& p)
{
  if (wave.kind == Wave::SEGMENT)
    return wave.sigma + distance_to_segment(wave, p);
  if (wave.kind != Wave::ALL_AROUND)
    for (std::size_t i = 0; i < 2; ++i) {
      const plane::Vector& end = wave.ends[i];
      const double turn = plane::cross(wave.kind == Wave::FRONT ? wave.from : plane::difference(end, wave.from),
                                       plane::difference(p, end));
      if (i == 0 ? turn < 0 : turn > 0) // beside the bundle
        return wave.at_ends[i] + distance_in_plane(p, end);
    }
  return wave.sigma + (wave.kind == Wave::FRONT ? plane::dot(wave.from, p) : distance_in_plane(p, wave.from));
}

// Where a side of a face begins, relative to the first side, and its direction.
inline std::array<plane::Vector, 2> side_in_plane(const Laid_out_faces& surface, std::uint32_t side)
{
  const Laid_out_faces::Side& base = surface.side(side - side % 3);
  const std::array<plane::Vector, 3> corners{{{0, 0}, {base.length, 0}, {base.apex_x, base.apex_y}}};
  const plane::Vector& begin = corners[side % 3];
  return {begin, plane::unit(plane::difference(corners[(side + 1) % 3], begin))};
}

inline Wave wave_of(const Laid_out_faces& surface, const Window& w)
{
  const std::array<plane::Vector, 2> side = side_in_plane(surface, w.side);
  const plane::Vector &begin = side[0], &along = side[1];
  const auto turned = [&along](double x, double y) -> plane::Vector {
    return {x * along[0] - y * along[1], x * along[1] + y * along[0]};
  };
  const auto place = [&](double x, double y) -> plane::Vector {
    const plane::Vector way = turned(x, y);
    return {begin[0] + way[0], begin[1] + way[1]};
  };
  Wave wave{w.side / 3, w.source, w.kind == Window::FRONT ? Wave::FRONT : Wave::BUNDLE};
  wave.ends = {place(w.b1, 0), place(w.b0, 0)};
  wave.at_ends = {w.distance(w.b1), w.distance(w.b0)};
  if (w.kind == Window::FRONT) {
    wave.from = turned(w.x, w.y);
    wave.sigma = w.sigma - plane::dot(wave.from, begin);
  } else {
    wave.from = place(w.x, -w.y);
    wave.sigma = w.sigma;
  }
  return wave;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAVE_FUNCTIONS_H
