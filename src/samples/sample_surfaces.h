// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The built-in sample surfaces by name, as the command offers them; the
// generators themselves are in the headers that this one includes.

#ifndef IDT_SAMPLES_SAMPLE_SURFACES_H
#define IDT_SAMPLES_SAMPLE_SURFACES_H

#include "samples/sample_gluings.h"
#include "samples/sample_surface_types.h"
#include "samples/sample_surfaces_curved.h"
#include "samples/sample_surfaces_flat.h"

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace samples {

using Sample_surface = std::variant<Indexed_triangles, Glued_triangles>;

struct Sample
{
  std::string name;         ///< the argument of `make_sample()`
  std::string description;  ///< one line
  Sample_surface (*make)(); ///< with the default arguments of its generator
};

// returns the samples that `make_sample()` knows.
inline const std::vector<Sample>& sample_names()
{
  static const std::vector<Sample> samples = {
    {"bumpy-sphere", "a sphere with smooth bumps and many needles and obtuse triangles",
     []() -> Sample_surface { return bumpy_sphere(); }},
    {"disk-with-spike", "a round disk with a tall thin spike in the middle",
     []() -> Sample_surface { return disk_with_spike(); }},
    {"bumpy-dome", "an open dome with smooth bumps, whose triangles wind around it",
     []() -> Sample_surface { return bumpy_dome(); }},
    {"torus", "a torus with a regular grid of triangles", []() -> Sample_surface { return torus(); }},
    {"bad-torus", "a torus with random bad triangles", []() -> Sample_surface { return bad_torus(); }},
    {"prism", "a prism over a regular polygon with 80 corners, full of ties",
     []() -> Sample_surface { return prism(); }},
    {"Schwarz-lantern", "a cylinder folded into flat obtuse triangles",
     []() -> Sample_surface { return Schwarz_lantern(); }},
    {"helical-tube", "a long thin tube, a third of whose intrinsic edges are loops",
     []() -> Sample_surface { return helical_tube(); }},
    {"one-vertex-torus", "a flat torus of two triangles, given by lengths alone",
     []() -> Sample_surface { return one_vertex_torus(); }},
    {"cap", "a kite with a chain of vertices 1e-10 away from its diagonal", []() -> Sample_surface { return cap(); }},
    {"sliver-sheet", "a wavy sheet squeezed to a width of 1e-9", []() -> Sample_surface { return sliver_sheet(); }},
    {"pillow", "a flat pillow of 300 vertices that needs more than 45,000 flips",
     []() -> Sample_surface { return pillow(); }},
    {"strip", "a long thin strip that needs 298,110 flips", []() -> Sample_surface { return strip(); }},
    {"random-diagonal-grid", "unit squares split at random, where every diagonal is a tie",
     []() -> Sample_surface { return random_diagonal_grid(); }},
    {"sheared-grid", "a grid of squares sheared along its rows", []() -> Sample_surface { return sheared_grid(); }},
    {"latitude-longitude-sphere", "a sphere with meridians, circles of latitude and pole fans",
     []() -> Sample_surface { return latitude_longitude_sphere(); }},
  };
  return samples;
}

// returns the sample surface with this name, made with the default arguments of its generator.
// \throws std::invalid_argument with a list of the valid names, if `name` is not one of them
inline Sample_surface make_sample(const std::string& name)
{
  std::string known;
  for (const Sample& sample : sample_names()) {
    if (name == sample.name)
      return sample.make();
    known += (known.empty() ? "" : ", ") + sample.name;
  }
  throw std::invalid_argument("unknown sample surface \"" + name + "\"; known are " + known);
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_SURFACES_H
