// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signed distances from closed curves beside those of geometry-central by heat and by fast marching: errors against our
// exact ones, and processor times.
//
//   signed_distances MESH...   from the longest line at three tenths of the largest distance from vertex 0

#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include "geometrycentral/surface/fast_marching_method.h"
#include "geometrycentral/surface/manifold_surface_mesh.h"
#include "geometrycentral/surface/signed_heat_method.h"
#include "geometrycentral/surface/vertex_position_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace gc = geometrycentral;
namespace gcs = geometrycentral::surface;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Distances = std::vector<double>;
using Curve = std::vector<IT::Surface_point>;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Mesh read(const std::string& path)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons))
    throw std::runtime_error("cannot be read");
  Mesh mesh;
  for (const auto& p : points)
    mesh.points.push_back({p.x(), p.y(), p.z()});
  for (const auto& polygon : polygons)
    mesh.triangles.push_back(
      {std::uint32_t(polygon.at(0)), std::uint32_t(polygon.at(1)), std::uint32_t(polygon.at(2))});
  return mesh;
}

double largest(const Distances& distances)
{
  double result = 0;
  for (double d : distances)
    if (std::isfinite(d))
      result = (std::max)(result, std::abs(d));
  return result;
}

// From the mesh.
Distances signed_distances(const Mesh& mesh, const Curve& curve, double tolerance)
{
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles), mesh.points);
  IT::flip_to_Delaunay(triangulation);
  Distances result =
    IT::geodesic_distances_from(triangulation, {{{curve}}}, CGAL::parameters::tolerance(tolerance)).distances;
  const std::vector<CGAL::Sign> sides = IT::sides_of_curve(triangulation.input(), {curve});
  for (std::size_t v = 0; v < result.size(); ++v)
    if (sides[v] == CGAL::NEGATIVE)
      result[v] = -result[v];
  return result;
}

// A closed curve from edge to edge, without turning back at one: theirs takes one piece in each face.
Curve straight_through_faces(const IT::Delta_complex& input, const Curve& curve)
{
  const auto edge = [&](IT::Surface_point p) {
    while (p.coordinates[2] > 0) {
      p.halfedge = input.next(p.halfedge);
      std::rotate(p.coordinates.begin(), p.coordinates.begin() + 1, p.coordinates.end());
    }
    return input.edge(p.halfedge);
  };
  Curve result;
  for (auto p = curve.begin() + 1; p != curve.end(); ++p)
    if (p->dimension() == 0)
      throw std::runtime_error("the line runs through a vertex");
    else if (p->dimension() == 1 && !result.empty() && edge(result.back()) == edge(*p))
      result.pop_back();
    else if (p->dimension() == 1)
      result.push_back(*p);
  while (result.size() > 1 && edge(result.front()) == edge(result.back())) {
    result.pop_back();
    result.erase(result.begin());
  }
  result.push_back(result.front());
  return result;
}

class Their_surface
{
public:
  explicit Their_surface(const Mesh& mesh) : mesh_(polygons(mesh)), geometry_(mesh_)
  {
    for (gcs::Vertex v : mesh_.vertices()) {
      const auto& p = mesh.points[v.getIndex()];
      geometry_.vertexPositions[v] = {p[0], p[1], p[2]};
    }
  }

  // \param input on which the curve lies
  std::vector<gcs::SurfacePoint> curve(const IT::Delta_complex& input, const Curve& given)
  {
    std::vector<gcs::SurfacePoint> result;
    for (const IT::Surface_point& p : given)
      result.push_back(point(input, p));
    return result;
  }

  Distances by_heat(const std::vector<gcs::SurfacePoint>& curve)
  {
    gcs::SignedHeatSolver solver(geometry_);
    try {
      return numbers(solver.computeDistance({gcs::Curve{curve, true}}));
    } catch (const std::invalid_argument&) { // its matrix is singular
      is_unconstrained = true;
      gc::SignedHeatOptions options;
      options.levelSetConstraint = gc::LevelSetConstraint::None;
      return numbers(solver.computeDistance({gcs::Curve{curve, true}}, options));
    }
  }
  Distances by_marching(const std::vector<gcs::SurfacePoint>& curve)
  {
    std::vector<std::pair<gcs::SurfacePoint, double>> nodes;
    for (const gcs::SurfacePoint& p : curve)
      nodes.push_back({p, 0});
    return numbers(
      gcs::FMMDistance(geometry_, std::vector<std::vector<std::pair<gcs::SurfacePoint, double>>>{nodes}, true));
  }

  bool is_unconstrained = false; // whether the curve was not made the zero set, which is the default

private:
  static std::vector<std::vector<std::size_t>> polygons(const Mesh& mesh)
  {
    std::vector<std::vector<std::size_t>> result;
    for (const auto& t : mesh.triangles)
      result.push_back({t[0], t[1], t[2]});
    return result;
  }

  gcs::SurfacePoint point(const IT::Delta_complex& input, const IT::Surface_point& p)
  {
    std::vector<std::pair<std::size_t, double>> corners; // of the face, with their coordinates
    IT::Halfedge_index h = p.halfedge;
    for (double x : p.coordinates) {
      corners.push_back({input.source(h).idx(), x});
      h = input.next(h);
    }
    const gcs::Face f = mesh_.face(input.face(h).idx());
    const auto at = [&](gcs::Vertex v) {
      return std::find_if(corners.begin(), corners.end(), [v](const auto& c) { return c.first == v.getIndex(); })
        ->second;
    };
    gc::Vector3 in_face;
    std::size_t i = 0;
    for (gcs::Halfedge g : f.adjacentHalfedges()) {
      const double here = at(g.tailVertex()), there = at(g.tipVertex());
      in_face[i++] = here;
      if (here > 0 && there > 0 && here + there == here + there + at(g.next().tipVertex()))
        return gcs::SurfacePoint(g, there / (here + there));
      if (here > 0 && there == 0 && at(g.next().tipVertex()) == 0)
        return gcs::SurfacePoint(g.tailVertex());
    }
    return gcs::SurfacePoint(f, in_face / (in_face[0] + in_face[1] + in_face[2]));
  }

  Distances numbers(const gcs::VertexData<double>& values) const
  {
    Distances result(mesh_.nVertices());
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = values[v];
    return result;
  }

  gcs::ManifoldSurfaceMesh mesh_;
  gcs::VertexPositionGeometry geometry_;
};

// Their sign may be the opposite.
std::string errors(const Distances& exact, const Distances& found)
{
  double best = std::numeric_limits<double>::infinity(), most = 0;
  std::size_t wrong = 0;
  for (double sign : {1., -1.}) {
    double sum = 0, worst = 0;
    std::size_t opposite = 0;
    for (std::size_t v = 0; v < exact.size(); ++v) {
      const double error = std::abs(sign * found[v] - exact[v]);
      sum += error;
      worst = error <= worst ? worst : error; // NaN is the worst
      opposite += sign * found[v] * exact[v] < 0 ? 1 : 0;
    }
    if (!(sum >= best)) {
      best = sum;
      most = worst;
      wrong = opposite;
    }
  }
  char text[100];
  const double size = largest(exact);
  std::snprintf(text, sizeof(text), "%.2g %%, %.2g %% | %zu", 100 * best / double(exact.size()) / size,
                100 * most / size, wrong);
  return text;
}

void compare(const std::string& path)
{
  const Mesh mesh = read(path);
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles), mesh.points);
  IT::flip_to_Delaunay(triangulation);
  const IT::Geodesic_source start = IT::source_at_vertex(triangulation.input(), IT::Vertex_index(0));
  const double level = 0.3 * largest(IT::geodesic_distances_from(triangulation, {start}).distances);
  const auto lines =
    IT::isolines(triangulation, {start}, {level}, CGAL::parameters::maximum_deviation(1e-3 * level)).lines;
  Curve curve = std::max_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
                  return a.points.size() < b.points.size();
                })->points;
  curve = straight_through_faces(triangulation.input(), curve);

  const std::string name = path.substr(path.find_last_of('/') + 1);
  std::printf("| %s, %zu, %zu", name.c_str(), mesh.triangles.size(), curve.size() - 1);
  double begin = processor_seconds();
  const Distances exact = signed_distances(mesh, curve, 0);
  std::printf(" | %.2f s", processor_seconds() - begin);
  begin = processor_seconds();
  const Distances usual = signed_distances(mesh, curve, 0.001);
  const double seconds = processor_seconds() - begin;
  std::printf(" | %s | %.2f s", errors(exact, usual).c_str(), seconds);
  for (bool is_heat : {true, false}) {
    begin = processor_seconds();
    try {
      Their_surface theirs(mesh);
      const auto nodes = theirs.curve(triangulation.input(), curve);
      const Distances found = is_heat ? theirs.by_heat(nodes) : theirs.by_marching(nodes);
      const double spent = processor_seconds() - begin;
      std::printf(" | %s | %.2f s%s", errors(exact, found).c_str(), spent, theirs.is_unconstrained ? " *" : "");
    } catch (const std::exception& error) {
      std::printf(" | %s | |", error.what());
    }
  }
  std::printf(" |\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  std::printf("| surface, faces, segments | exact | default: mean, largest error | wrong signs | time | heat: mean, "
              "largest error | wrong signs | time | marching: mean, largest error | wrong signs | time |\n");
  for (int i = 1; i < argc; ++i)
    try {
      compare(argv[i]);
    } catch (const std::exception& error) {
      std::printf("\n%s: %s\n", argv[i], error.what());
    }
  return 0;
}
