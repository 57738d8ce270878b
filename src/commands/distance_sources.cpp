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
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;
using Sources = std::vector<IT::Geodesic_source>;
using Points_in_faces = std::vector<IT::Point_in_triangle>;

// A surface whose faces the user numbers.
struct Faces
{
  std::size_t number;
  std::function<std::array<std::uint32_t, 3>(std::size_t)> corners;
  std::function<Sources(const std::vector<Points_in_faces>&)> find; // points and curves in them
  std::function<IT::Point_in_triangle(const IT::Surface_point&)> number_of;
  // where several faces meet at an edge: the shortest path from stop to stop
  std::function<IT::Path_on_triangles(const Points_in_faces&)> path;
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
        for (IT::Geodesic_source& point : found(placed(apart, named_.points_path), apart, named_.points_path))
          result_.sources.push_back(std::move(point));
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
  std::vector<Points_in_faces> placed(const std::vector<std::vector<Place>>& curves, const std::string& path)
  {
    std::vector<Points_in_faces> result(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (const Place& place : curves[i])
        result[i].push_back(place.kind == Place::IN_SPACE ? foot(place) : in_triangle(place, path));
    return result;
  }

  Sources found(const std::vector<Points_in_faces>& placed, const std::vector<std::vector<Place>>& curves,
                const std::string& path) const
  {
    try {
      return faces_.find(placed);
    } catch (const IT::Invalid_point_error&) {
      for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = 0; k < placed[i].size(); ++k)
          try {
            const auto end = placed[i].begin() + std::ptrdiff_t(k) + 1;
            faces_.find({Points_in_faces(k > 0 ? end - 2 : end - 1, end)});
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

  IT::Point_in_triangle foot(const Place& place)
  {
    if (points_.empty())
      throw Usage_error("points in space need a surface in space: give input_face,b0,b1,b2");
    const IT::Surface_point nearest = IT::locate(input_, points_, place.numbers);
    const auto [x, y, z] = IT::point_in_space(input_, points_, nearest);
    result_.largest_snap =
      (std::max)(result_.largest_snap, std::hypot(x - place.numbers[0], y - place.numbers[1], z - place.numbers[2]));
    return faces_.number_of(nearest);
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
    const std::vector<Points_in_faces> points = placed(curves, named_.curve_path);
    std::vector<Points_in_faces> in_faces = points;
    std::vector<bool> has_stops;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      has_stops.push_back(!curves[i].empty() && curves[i].front().kind != Place::BETWEEN_VERTICES);
      if (has_stops[i] && faces_.path)
        in_faces[i] = path(points[i], curves[i]);
      else if (has_stops[i]) // found one by one
        in_faces[i].clear();
      else
        require_common_faces(curves[i]);
    }
    Sources sources = found(in_faces, curves, named_.curve_path);
    if (!faces_.path)
      go_straight(points, has_stops, curves, sources);
    for (IT::Geodesic_source& curve : sources)
      result_.sources.push_back(std::move(curve));
  }

  Points_in_faces path(const Points_in_faces& stops, const std::vector<Place>& places) const
  {
    try {
      IT::Path_on_triangles result = faces_.path(stops);
      if (!result.is_complete)
        fail(places.front(), named_.curve_path,
             "the shortest path to the next point was not found: give the curve more points");
      return std::move(result.points);
    } catch (const IT::Invalid_argument_error&) {
      for (std::size_t i = 1; i < stops.size(); ++i)
        try {
          faces_.path({stops[i - 1], stops[i]});
        } catch (const IT::Invalid_argument_error&) {
          fail(places[i], named_.curve_path, no_path);
        }
      throw;
    }
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

  // Points on edges of the input are inserted before these are flipped. Faces beside new vertices may be slivers, which
  // ways do not cross well: Delaunay faces are not.
  // \param has_stops other curves remain
  void go_straight(const std::vector<Points_in_faces>& points, const std::vector<bool>& has_stops,
                   const std::vector<std::vector<Place>>& curves, Sources& sources) const
  {
    if (std::find(has_stops.begin(), has_stops.end(), true) == has_stops.end())
      return;
    Triangulation copy =
      points_.size() == input_.number_of_vertices() ? Triangulation(input_, points_) : triangulation_;
    std::vector<Points_in_faces> apart;
    std::vector<std::vector<Place>> places;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < points[i].size() && has_stops[i]; ++k) {
        apart.push_back({points[i][k]});
        places.push_back({curves[i][k]});
      }
    const Sources located = found(apart, places, named_.curve_path);
    std::vector<std::vector<IT::Vertex_index>> stops(points.size());
    auto next = located.begin();
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < points[i].size() && has_stops[i]; ++k, ++next) {
        IT::Surface_point p = next->parts.front().front();
        p.coordinates = IT::internal::on_near_edges(p.coordinates);
        if (k == 0)
          sources[i].parts = {{p}};
        stops[i].push_back(IT::vertex_at_point(copy, p));
      }
    const auto np = CGAL::parameters::visitor([] { return !is_interrupted(); });
    IT::flip_to_Delaunay(copy, np);
    // Straight, even if not all ways could be followed.
    IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(copy);
    for (std::size_t k = 0; k < stops.size(); ++k)
      for (std::size_t i = 0; i + 1 < stops[k].size(); ++i) {
        IT::internal::Path_over_stops line;
        line.points.swap(sources[k].parts.front());
        try {
          line.append_shortest(copy, network, stops[k][i], stops[k][i + 1], np);
        } catch (const IT::Invalid_argument_error&) {
          fail(curves[k][i + 1], named_.curve_path, no_path);
        }
        line.points.swap(sources[k].parts.front());
      }
  }

  static constexpr const char* no_path = "no path leads here from the point before: the curve leaves its component";

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
  const auto find = [&input, first_side](const std::vector<Points_in_faces>& given) {
    Sources result;
    for (const Points_in_faces& points : given) {
      result.push_back({{{}}});
      for (const IT::Point_in_triangle& p : points) {
        if (p.triangle >= input.number_of_faces())
          throw IT::Invalid_point_error("there is no face " + std::to_string(p.triangle) + ": the surface has " +
                                        std::to_string(input.number_of_faces()) + ", counted from 0");
        result.back().parts.front().push_back({first_side(p.triangle), p.coordinates});
      }
    }
    return result;
  };
  const auto number_of = [&input, first_side](const IT::Surface_point& p) {
    const std::size_t f = input.face(p.halfedge).idx();
    return IT::Point_in_triangle{f, IT::coordinates_from(input, p, first_side(f))};
  };
  return Source_placer(named, triangulation, points, {input.number_of_faces(), corners, find, number_of, {}}, vertex_of,
                       vertex_of)
    .place();
}

Placed_sources place_sources(const Named_sources& named, const IT::Tufted_cover& cover, const Points& points,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  Points of_cover;
  for (std::uint32_t v : cover.vertex_of)
    if (!points.empty())
      of_cover.push_back(points[v]);
  const IT::internal::Points places = IT::internal::copy_points(points);
  Faces faces{triangles.size(),
              [&](std::size_t f) { return triangles[f]; },
              [&](const std::vector<Points_in_faces>& given) { return IT::sources_on_cover(cover, triangles, given); },
              [&](const IT::Surface_point& p) { return IT::internal::point_below_cover(cover, places, triangles, p); },
              {}};
  const bool is_surface = cover.vertex_of.size() == cover.representative.size() && !cover.is_cut &&
                          cover.report.nonmanifold_edges == 0 && cover.flat_edges.empty();
  if (!is_surface && !points.empty())
    faces.path = [&](const Points_in_faces& stops) {
      return IT::shortest_path_on_triangles(points, triangles, stops,
                                            CGAL::parameters::visitor([] { return !is_interrupted(); }));
    };
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
