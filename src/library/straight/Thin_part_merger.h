// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Merges parts of straight triangles that are thinner than the largest deviation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H

#include <CGAL/Intrinsic_triangulations/observer.h>
#include "Straight_map.h"
#include "crossing_triangles.h"
#include "nearness.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Triangles by vertices of the triangulation. A removed one has equal corners.
struct Straight_triangles
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Triangle> triangles;
  std::vector<Face_index> faces; // of the triangulation: where a triangle belongs
  std::vector<bool> is_kept;     // whether a small angle is to stay
  std::vector<std::array<std::uint32_t, 2>> marked_edges;
  std::vector<bool> is_fixed;       // whether a vertex must not move, or empty
  std::vector<bool> must_not_cross; // whether steps at a face must not make triangles cross, or empty
};

// Improves thin triangles, as long as surface and triangles stay within the bound of each other:
// - It contracts edges, flips them, and moves vertices. A marked edge, or one of the border, is flipped by bending it to a
//   corner near it.
// - Where four triangles meet at an edge, as around a thin tube, it separates the two sheets. Where three short edges run
//   around a tube, it cuts the tube and closes both ends.
// - It removes pieces that then lie beside others, and turns wires that do not into rods. A component that came apart
//   into neighbors along a line becomes one rod.
// - It leaves out films: two sheets that lie on each other, and enclose no volume between them.
//
// Each triangle stands for faces of the triangulation: each point of it is near one of them, and each of their points is
// near one of the triangles that stand for that face. At first, a triangle stands for its own face.
class Thin_part_merger
{
public:
  using Triangle = Straight_triangles::Triangle;

  Thin_part_merger(Straight_map& map, Straight_triangles& mesh, double thin_angle, double maximum_deviation,
                   const Progress_function& progress);

  // \return the largest distance of the two surfaces
  Straight_map::Distance operator()();
  // For each vertex of the triangulation, the vertex that it was merged with, or itself.
  const std::vector<std::uint32_t>& images() const { return images_; }
  std::size_t number_of_removed_pieces() const { return number_of_removed_pieces_; }
  // The faces that some triangles stand for, in order.
  std::vector<Face_index> faces_of(const std::vector<std::uint32_t>& triangles) const;
  std::size_t number_of_rods() const { return number_of_rods_; }
  // Whether a triangle is of a film that is left out.
  bool is_left_out(std::uint32_t t) const { return is_of_film_[mesh_.triangles[t][0]]; }
  // Of one sheet of the films.
  double area_of_films() const { return area_of_films_; }
  const std::array<double, 3>& place_of_film() const { return place_of_film_; }
  // How many more components there are because components of the surface came apart.
  std::size_t number_of_new_components() const;
  // How many edges of the border were replaced by two.
  std::size_t number_of_bent_border_edges() const { return number_of_bent_border_edges_; }

private:
  using Point = std::array<double, 3>;
  // Triangles that get other corners: equal ones if they vanish.
  struct Change
  {
    std::vector<std::uint32_t> triangles;
    std::vector<Triangle> corners;
    std::vector<std::uint32_t> beside; // triangles that stay, and may stand for more faces
    std::vector<std::pair<std::uint32_t, Face_index>> stands_for = {}; // which triangles stand for which faces then
  };
  using Gain = std::pair<int, double>; // how many thin triangles vanish, and the factor of the smallest angle
  static constexpr Gain no_gain{(std::numeric_limits<int>::min)(), 0};
  // A hub of more triangles does not move, so that no step takes long.
  static constexpr std::size_t most_around = 16;
  // The surface in faces, as triangles.
  struct Surface_part
  {
    std::vector<Space_triangle> triangles;
    std::vector<Face_index> faces; // of each triangle
  };

  static bool is_removed(const Triangle& t) { return t[0] == t[1]; }
  static std::uint32_t after(const Triangle& corners, std::uint32_t v);
  bool is_thin(std::uint32_t t, double angle) const;
  bool is_bad(std::uint32_t t) const;
  void improve_all();
  bool improve(std::uint32_t t);
  bool force(std::uint32_t t);

  Straight_map::Distance largest_distance();
  Surface_part surface_in(const std::vector<Face_index>& faces);

  std::vector<Space_triangle> in_space(const std::vector<Triangle>& triangles) const;
  Gain gain(const Change& change, const std::vector<Space_triangle>& before) const;
  bool improves(const Change& change, const std::vector<Space_triangle>& before) const;
  std::vector<Space_triangle> places(const Change& change) const;
  bool is_near_enough(Change& change);
  bool is_within(Change& change, double distance);
  bool makes_crossings(const Change& change);
  void make(const Change& change);
  void add_face(std::uint32_t t, Face_index f);
  bool try_to_make(Change& change);

  bool is_contractible(std::uint32_t from, std::uint32_t to);
  Change contraction(std::uint32_t from, std::uint32_t to) const;
  bool contract(std::uint32_t from, std::uint32_t to);
  bool flip(std::uint32_t t, std::uint32_t a, std::uint32_t b);
  bool move_to_mean(std::uint32_t v);
  bool move_along_edges(std::uint32_t v);
  bool move(std::uint32_t v, const std::vector<Point>& toward, const std::vector<double>& parts);

  bool cut_tube(std::uint32_t v, std::uint32_t w);
  std::vector<std::uint32_t> fan_between(std::uint32_t first, std::uint32_t v, std::uint32_t to) const;
  bool separate(std::uint32_t v, std::uint32_t w);
  void separate_fans(std::uint32_t v);
  void separate_fans_around(std::uint32_t v);
  void move_to_copy(std::uint32_t v, const std::vector<std::uint32_t>& triangles);

  std::map<std::uint32_t, std::vector<std::uint32_t>> pieces() const;
  std::uint32_t component_of(std::uint32_t t) const;
  bool is_bad_piece(const std::vector<std::uint32_t>& piece) const;
  std::vector<std::vector<std::uint32_t>> small_pieces() const;
  void remove_pieces();
  bool replace_by_rod(const std::vector<std::uint32_t>& piece);
  void remove_piece(const Change& change, std::size_t number_of_triangles);

  // The triangles s = abc and t = bad at an edge ab.
  struct Fold
  {
    std::uint32_t a, b, c, d, s, t;
  };
  // What triangles enclose.
  struct Bulk
  {
    double volume = 0, area = 0;
    bool is_closed = true;
    std::uint32_t origin = 0; // a corner
  };
  void add(Bulk& bulk, std::uint32_t t) const;
  double smallest_volume() const { return maximum_deviation_ * maximum_deviation_ * maximum_deviation_; }
  bool is_thick(const Bulk& bulk) const;
  std::vector<bool> find_solids() const;
  double thickness_at(std::uint32_t t, const std::vector<std::uint32_t>& triangles, const Box_tree& tree) const;
  void leave_films_out();
  void leave_cavities_out();
  void leave_crumbs_out();
  void leave_out(const std::vector<std::uint32_t>& triangles, const Bulk& bulk);
  bool is_folded(std::uint32_t t) const;
  double area(const Triangle& t) const;
  bool can_be_left_out(Change& change);
  std::vector<std::uint32_t> zip(std::uint32_t a, std::uint32_t b);
  std::vector<std::uint32_t> contract_fold(const Fold& fold);
  std::vector<std::uint32_t> flatten_fold(const Fold& fold);
  std::vector<std::uint32_t> zip_to_corner(const Fold& fold);
  std::vector<std::uint32_t> zip_to_side(const Fold& fold);
  std::vector<std::uint32_t> flip_to_side(const Fold& fold);
  std::vector<std::uint32_t> zip_to_crossing(const Fold& fold);
  using Line = std::array<std::uint32_t, 2>; // between vertices
  std::uint32_t add_copy(std::uint32_t t, std::uint32_t v);
  bool flip_across(std::deque<Line> crossed, std::uint32_t from, std::uint32_t to, const Point& normal,
                   std::vector<std::uint32_t>& changed);
  double side(const Point& normal, std::uint32_t v, std::uint32_t w, std::uint32_t x) const;
  void leave_out(Change& change, std::uint32_t t, Triangle corners);
  void change_triangle(Change& change, std::uint32_t t, const Triangle& corners);
  void divide_triangle(Change& change, std::uint32_t t, std::uint32_t v, std::uint32_t w, std::uint32_t x);
  void divide_mark(std::uint32_t v, std::uint32_t w, std::uint32_t x);
  std::vector<std::uint32_t> finish(const Change& change, const Fold& fold, std::uint32_t apex);
  void merge_vertex(std::uint32_t from, std::uint32_t to);
  void find_images_of_films();

  double length(std::uint32_t v, std::uint32_t w) const;
  std::vector<std::uint32_t> neighbors(std::uint32_t v) const;
  std::vector<std::uint32_t> triangles_at(std::uint32_t v, std::uint32_t w) const;
  std::size_t number_of_triangles_at(std::uint32_t v, std::uint32_t w) const { return triangles_at(v, w).size(); }
  bool is_on_border(std::uint32_t v) const;
  bool is_marked(std::uint32_t v, std::uint32_t w) const;
  bool is_hub(std::uint32_t v) const { return at_vertex_[v].size() > most_around; }
  bool is_fixed(std::uint32_t v) const { return v < mesh_.is_fixed.size() && mesh_.is_fixed[v]; }
  void replace(std::uint32_t t, const Triangle& corners);
  std::uint32_t add_triangle(std::uint32_t beside);
  std::uint32_t add_vertex(const Point& p);
  void look_at(std::uint32_t v, const std::vector<std::uint32_t>& changed = {});

  void report(double fraction) const { report_progress(progress_, fraction, "straight_mesh()"); }

  Straight_map& map_;
  Straight_triangles& mesh_;
  const Progress_function& progress_;
  const double thin_angle_, maximum_deviation_, most_; // a little less, for rounding
  std::vector<std::vector<std::uint32_t>> at_vertex_;  // the triangles
  std::vector<std::vector<std::uint32_t>> marked_;     // the vertices at the other ends of marked edges
  // The faces that a triangle stands for, if it is not its own face as at first.
  std::unordered_map<std::uint32_t, std::vector<Face_index>> stands_for_;
  std::vector<std::vector<std::uint32_t>> stand_for_face_; // the other way round
  std::optional<Box_tree> face_tree_;                      // of the surface in each face, if nothing must cross
  std::vector<std::uint32_t> component_of_face_;           // by a vertex of the component
  std::vector<std::uint32_t> images_, to_look_at_;
  std::vector<bool> is_of_film_;               // whether a vertex is one of triangles that are left out
  std::vector<bool> is_merged_;                // whether other vertices were merged with a vertex
  std::vector<bool> is_at_film_;               // whether triangles at a vertex were left out
  std::vector<bool> is_solid_;                 // for each component, whether films of it may be left out
  const double near_ = maximum_deviation_ / 2; // what is nearer becomes one where sheets are zipped
  double area_of_films_ = 0;
  std::size_t number_of_zips_ = 0, number_of_flipped_sides_ = 0;
  Point place_of_film_{};
  std::vector<bool> is_waiting_, is_stuck_; // whether a triangle is to be looked at, or waits for a forced step
  Gain needed_gain_;                        // more is needed for a step
  double lowest_with_normal_ = 0;           // the height of triangles that must not turn over
  std::size_t number_of_removed_pieces_ = 0, number_of_rods_ = 0, number_of_bent_border_edges_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_THIN_PART_MERGER_H
