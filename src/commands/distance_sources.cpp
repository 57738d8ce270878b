// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/distance_sources.h"

#include "commands/command_line.h"
#include "system/Interruption.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;
using Parts = std::vector<std::vector<IT::Surface_point>>;

// A surface whose faces the user numbers.
struct Faces
{
  std::size_t number;
  std::function<std::array<std::uint32_t, 3>(std::size_t)> corners;
  std::function<Parts(const std::vector<std::vector<IT::Point_in_triangle>>&)> find; // points and curves in them
};

class Source_placer
{
public:
  // \param vertex_of the vertex of the user, for each vertex of the surface
  // \param representative of each vertex of the user, another one if they were merged
  Source_placer(const Named_sources& named, const Triangulation& triangulation, const Points& points, Faces faces,
                std::vector<std::uint32_t> vertex_of, std::vector<std::uint32_t> representative)
    : named_(named), triangulation_(triangulation), input_(triangulation.input()), points_(points),
      faces_(std::move(faces)), vertex_of_(std::move(vertex_of)), representative_(std::move(representative))
  {}

  Placed_sources place()
  {
    for (std::uint64_t v : named_.vertices)
      result_.sources.push_back(IT::source_at_vertex(input_, vertex(v)));
    if (!named_.points_path.empty())
      for (const std::vector<Place>& places : read_places(named_.points_path)) {
        std::vector<std::vector<Place>> apart;
        for (const Place& place : places)
          apart.push_back({place});
        for (std::vector<IT::Surface_point>& point : placed(apart, named_.points_path))
          result_.sources.push_back({{std::move(point)}});
      }
    if (!named_.edges_path.empty())
      add_edges();
    if (!named_.curve_path.empty())
      add_curves(read_places(named_.curve_path));
    if (!points_.empty())
      for (const IT::Geodesic_source& source : result_.sources)
        for (const std::vector<IT::Surface_point>& part : source.parts)
          add_in_space(part);
    return std::move(result_);
  }

private:
  void add_in_space(const std::vector<IT::Surface_point>& part)
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    auto& places = part.size() == 1 ? result_.points : result_.curves;
    if (part.size() > 1)
      places.push_back({none, none, none});
    for (const IT::Surface_point& p : part)
      places.push_back(IT::point_in_space(input_, points_, p));
  }

  std::uint32_t representative(std::uint64_t number) const
  {
    if (number >= representative_.size())
      throw Usage_error("there is no vertex " + std::to_string(number) + ": the input has " +
                        std::to_string(representative_.size()) + ", counted from 0");
    return representative_[number];
  }

  IT::Vertex_index vertex(std::uint64_t number) const
  {
    const auto found = std::find(vertex_of_.begin(), vertex_of_.end(), representative(number));
    if (found == vertex_of_.end())
      throw Usage_error("vertex " + std::to_string(number) + " has no face");
    return IT::Vertex_index(IT::Vertex_index::size_type(found - vertex_of_.begin()));
  }

  // The points of curves.
  Parts placed(const std::vector<std::vector<Place>>& curves, const std::string& path)
  {
    std::vector<std::vector<IT::Point_in_triangle>> given(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Place& place : curves[i])
        if (place.kind != Place::IN_SPACE)
          given[i].push_back(in_triangle(place, path));
    Parts result = found_in_faces(given, curves, path);
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Place& place : curves[i])
        if (place.kind == Place::IN_SPACE)
          result[i].push_back(foot(place));
    return result;
  }

  Parts found_in_faces(const std::vector<std::vector<IT::Point_in_triangle>>& given,
                       const std::vector<std::vector<Place>>& curves, const std::string& path) const
  {
    try {
      return faces_.find(given);
    } catch (const IT::Invalid_point_error&) {
      for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = 0; k < given[i].size(); ++k)
          try {
            faces_.find({{given[i][k]}});
          } catch (const IT::Invalid_point_error& error) {
            fail(curves[i][k], path, error.what());
          }
      throw;
    }
  }

  [[noreturn]] static void fail(const Place& place, const std::string& path, const std::string& what)
  {
    throw IT::Invalid_point_error(path + ", line " + std::to_string(place.line) + ": " + what);
  }

  IT::Surface_point foot(const Place& place)
  {
    if (points_.empty())
      throw Usage_error("points in space need a surface in space: give input_face,b0,b1,b2");
    IT::Surface_point result = IT::locate(input_, points_, place.numbers);
    const auto [x, y, z] = IT::point_in_space(input_, points_, result);
    result_.largest_snap =
      (std::max)(result_.largest_snap, std::hypot(x - place.numbers[0], y - place.numbers[1], z - place.numbers[2]));
    return result;
  }

  // Coordinates may be given for vertices in any order.
  IT::Point_in_triangle in_triangle(const Place& place, const std::string& path) const
  {
    IT::Point_in_triangle result{std::size_t(place.face), place.numbers};
    if (place.kind == Place::BETWEEN_VERTICES && place.face < faces_.number)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = faces_.corners(result.triangle)[i];
        const auto corner = std::find_if(place.corners.begin(), place.corners.end(),
                                         [&](std::uint64_t w) { return representative(w) == representative(v); });
        if (corner == place.corners.end())
          fail(place, path, "face " + std::to_string(place.face) + " has other vertices");
        result.coordinates[i] = place.numbers[std::size_t(corner - place.corners.begin())];
      }
    return result;
  }

  void add_edges()
  {
    std::vector<std::pair<std::pair<std::uint64_t, std::uint64_t>, IT::Edge_index>> edges;
    for (IT::Edge_index e : input_.edges()) {
      const IT::Halfedge_index h = input_.halfedge(e);
      edges.push_back(
        {std::minmax<std::uint64_t>(vertex_of_[input_.source(h).idx()], vertex_of_[input_.target(h).idx()]), e});
    }
    std::sort(edges.begin(), edges.end());
    IT::Geodesic_source source;
    for (const auto& [v, w] : read_vertex_pairs(named_.edges_path)) {
      const std::pair<std::uint64_t, std::uint64_t> ends =
        std::minmax<std::uint64_t>(representative(v), representative(w));
      auto found = std::lower_bound(edges.begin(), edges.end(), std::make_pair(ends, IT::Edge_index(0)));
      if (found == edges.end() || found->first != ends)
        throw IT::Invalid_point_error(named_.edges_path + ": no edge joins vertex " + std::to_string(v) +
                                      " and vertex " + std::to_string(w));
      for (; found != edges.end() && found->first == ends; ++found)
        source.parts.push_back(IT::source_at_edge(input_, found->second).parts.front());
    }
    result_.sources.push_back(std::move(source));
  }

  // Points of `idt geodesic` follow each other in faces. Between others, a curve takes the shortest path.
  void add_curves(const std::vector<std::vector<Place>>& curves)
  {
    Parts given = placed(curves, named_.curve_path);
    std::vector<std::vector<IT::Vertex_index>> stops(curves.size());
    std::optional<Triangulation> copy;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (curves[i].empty() || curves[i].front().kind == Place::BETWEEN_VERTICES) {
        require_common_faces(curves[i]);
        continue;
      }
      // Points on edges of the input are inserted before these are flipped. Faces beside new vertices may be slivers,
      // which ways do not cross well: Delaunay faces are not.
      if (!copy && points_.size() == input_.number_of_vertices())
        copy.emplace(input_, points_);
      else if (!copy)
        copy.emplace(triangulation_);
      for (IT::Surface_point p : given[i]) {
        p.coordinates = IT::internal::on_near_edges(p.coordinates);
        stops[i].push_back(IT::vertex_at_point(*copy, p));
      }
    }
    if (copy)
      go_straight(*copy, stops, given);
    for (std::vector<IT::Surface_point>& curve : given)
      result_.sources.push_back({{std::move(curve)}});
  }

  void require_common_faces(const std::vector<Place>& places) const
  {
    for (std::size_t i = 1; i < places.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (places[i].numbers[k] > 0 && places[i].face != places[i - 1].face &&
            std::none_of(places[i - 1].corners.begin(), places[i - 1].corners.end(),
                         [&](std::uint64_t v) { return representative(v) == representative(places[i].corners[k]); }))
          fail(places[i], named_.curve_path,
               "the point does not lie in the face of the point before, face " + std::to_string(places[i - 1].face));
  }

  // \param stops vertices of the triangulation; curves without any remain
  static void go_straight(Triangulation& triangulation, const std::vector<std::vector<IT::Vertex_index>>& stops,
                          std::vector<std::vector<IT::Surface_point>>& curves)
  {
    const auto np = CGAL::parameters::visitor([] { return !is_interrupted(); });
    IT::flip_to_Delaunay(triangulation, np);
    // Straight, even if not all ways could be followed.
    IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(triangulation);
    for (std::size_t k = 0; k < stops.size(); ++k) {
      if (stops[k].empty())
        continue;
      std::vector<IT::Surface_point> curve{curves[k].front()};
      for (std::size_t i = 0; i + 1 < stops[k].size(); ++i) {
        if (stops[k][i] == stops[k][i + 1])
          continue;
        const std::size_t path =
          network.add_path(IT::shortest_path(triangulation, stops[k][i], stops[k][i + 1], np).halfedges);
        network.shorten(np);
        const std::vector<IT::Surface_point> part = IT::geodesic_points(triangulation, network.halfedges(path));
        curve.pop_back();
        curve.insert(curve.end(), part.begin(), part.end());
        network.rewind();
      }
      curves[k] = std::move(curve);
    }
  }

  const Named_sources& named_;
  const Triangulation& triangulation_;
  const IT::Delta_complex& input_;
  const Points& points_;
  Faces faces_;
  std::vector<std::uint32_t> vertex_of_, representative_;
  Placed_sources result_;
};

} // namespace

Placed_sources place_sources(const Named_sources& named, const Triangulation& triangulation, const Points& points)
{
  const IT::Delta_complex& input = triangulation.input();
  std::vector<std::uint32_t> vertex_of;
  for (IT::Vertex_index v : input.vertices())
    vertex_of.push_back(v.idx());
  const auto first_side = [&input](std::size_t f) {
    return input.halfedge(IT::Face_index(IT::Face_index::size_type(f)));
  };
  const auto corners = [&input, first_side](std::size_t f) -> std::array<std::uint32_t, 3> {
    const IT::Halfedge_index h = first_side(f);
    return {std::uint32_t(input.source(h).idx()), std::uint32_t(input.target(h).idx()),
            std::uint32_t(input.target(input.next(h)).idx())};
  };
  const auto find = [&input, first_side](const std::vector<std::vector<IT::Point_in_triangle>>& given) {
    Parts result(given.size());
    for (std::size_t i = 0; i < given.size(); ++i)
      for (const IT::Point_in_triangle& p : given[i]) {
        if (p.triangle >= input.number_of_faces())
          throw IT::Invalid_point_error("there is no face " + std::to_string(p.triangle) + ": the surface has " +
                                        std::to_string(input.number_of_faces()) + ", counted from 0");
        result[i].push_back({first_side(p.triangle), p.coordinates});
      }
    return result;
  };
  return Source_placer(named, triangulation, points, {input.number_of_faces(), corners, find}, vertex_of, vertex_of)
    .place();
}

Placed_sources place_sources(const Named_sources& named, const IT::Tufted_cover& cover, const Points& points,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  Points of_cover;
  for (std::uint32_t v : cover.vertex_of)
    if (!points.empty())
      of_cover.push_back(points[v]);
  const auto find = [&](const std::vector<std::vector<IT::Point_in_triangle>>& given) {
    return IT::points_of_cover(cover, triangles, given);
  };
  const Faces faces{triangles.size(), [&triangles](std::size_t f) { return triangles[f]; }, find};
  return Source_placer(named, cover.triangulation, of_cover, faces, cover.vertex_of, cover.representative).place();
}

IT::Surface_with_barriers place_barriers(const Named_sources& named, const Triangulation& triangulation,
                                         const Points& points, double& largest_snap)
{
  if (points.empty())
    throw Usage_error("barriers need a surface in space, and this one has only lengths: omit --barrier and "
                      "--barrier-edges");
  const Placed_sources placed = place_sources(named, triangulation, points);
  largest_snap = (std::max)(largest_snap, placed.largest_snap);
  std::vector<std::vector<IT::Surface_point>> curves;
  for (const IT::Geodesic_source& barrier : placed.sources)
    curves.insert(curves.end(), barrier.parts.begin(), barrier.parts.end());
  return IT::Surface_with_barriers(triangulation.input(), points, curves);
}

} // namespace idt
