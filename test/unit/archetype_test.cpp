// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The algorithms with types that offer only what the concepts require. Compiling is the test; the results show that the
// code is reached.

#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace archetype {

template <class Boolean_>
class Number
{
public:
  Number() = default; // without a value
  explicit Number(int i) : value_(i) {}
  explicit Number(double x) : value_(x) {}

  friend Number operator+(const Number& a, const Number& b) { return Number(a.value_ + b.value_); }
  friend Number operator-(const Number& a, const Number& b) { return Number(a.value_ - b.value_); }
  friend Number operator*(const Number& a, const Number& b) { return Number(a.value_ * b.value_); }
  friend Boolean_ operator<(const Number& a, const Number& b) { return a.value_ < b.value_; }
  friend Boolean_ operator>(const Number& a, const Number& b) { return a.value_ > b.value_; }
  friend Boolean_ operator==(const Number& a, const Number& b) { return a.value_ == b.value_; }

  double hidden() const { return value_; }

private:
  double value_;
};

// Not arithmetic, not comparable, and by default without a value.
class Edge
{
public:
  Edge() = default;
  static Edge of(double squared) { return Edge(squared); }
  double hidden() const { return squared_; }

protected:
  explicit Edge(double squared) : squared_(squared) {}
  double squared_;
};
class Face
{
public:
  Face() = default;
  static Face of(double four_areas) { return Face(four_areas); }
  double hidden() const { return four_areas_; }

protected:
  explicit Face(double four_areas) : four_areas_(four_areas) {}
  double four_areas_;
};
struct Flipped
{
  Edge kl;
  Face ilk;
  Face jkl;
};

template <class Boolean_>
class Traits
{
public:
  using FT = Number<Boolean_>;
  using Boolean = Boolean_;
  using Edge_data = Edge;
  using Face_data = Face;
  using Point_data = std::array<FT, 3>;
  using Hinge_data = IT::Hinge<Edge, Face>;
  using Flipped_hinge_data = Flipped;
  using Has_exact_decisions = CGAL::Tag_false;
  using Uses_exact_geometry = CGAL::Tag_false;

  explicit Traits(int) {} // not default constructible
  Traits(const Traits&) = default;
  Traits& operator=(const Traits&) = delete;

  struct Construct_edge_data
  {
    Edge operator()(const Point_data& p, const Point_data& q) const
    {
      double s = 0;
      for (int i = 0; i < 3; ++i)
        s += std::pow(p[i].hidden() - q[i].hidden(), 2);
      return Edge::of(s);
    }
    Edge from_length(const FT& l) const { return Edge::of(l.hidden() * l.hidden()); }
  };
  struct Construct_face_data
  {
    Face operator()(const Point_data& p, const Point_data& q, const Point_data& r) const
    {
      const Construct_edge_data edge;
      return from_edges(edge(p, q), edge(q, r), edge(r, p));
    }
    Face from_lengths(const FT& ij, const FT& jk, const FT& ki) const
    {
      const Construct_edge_data edge;
      return from_edges(edge.from_length(ij), edge.from_length(jk), edge.from_length(ki));
    }

  private:
    static Face from_edges(const Edge& ij, const Edge& jk, const Edge& ki)
    {
      return Face::of(std::sqrt(IT::squared_four_areas(ij.hidden(), jk.hidden(), ki.hidden())));
    }
  };
  struct Is_locally_Delaunay
  {
    Boolean operator()(const Hinge_data& h) const
    {
      const double p_k = h.jk.hidden() + h.ki.hidden() - h.ij.hidden();
      const double p_l = h.il.hidden() + h.lj.hidden() - h.ij.hidden();
      return p_k * h.jil.hidden() + p_l * h.ijk.hidden() >= 0;
    }
  };
  struct Construct_flipped_hinge
  {
    Boolean operator()(const Hinge_data& h, Flipped_hinge_data& f) const
    {
      double kl, ilk, jkl;
      IT::flip_hinge(h.ij.hidden(), h.jk.hidden(), h.ki.hidden(), h.il.hidden(), h.lj.hidden(), h.ijk.hidden(),
                     h.jil.hidden(), kl, ilk, jkl);
      f.kl = Edge::of(kl);
      f.ilk = Face::of(ilk);
      f.jkl = Face::of(jkl);
      return ilk > 0 && jkl > 0;
    }
  };
  struct Compute_squared_length
  {
    FT operator()(const Edge& e) const { return FT(e.hidden()); }
  };
  struct Compute_length
  {
    FT operator()(const Edge& e) const { return FT(std::sqrt(e.hidden())); }
  };
  struct Compute_area
  {
    FT operator()(const Face& f, const Edge&, const Edge&, const Edge&) const { return FT(f.hidden() / 4); }
  };
  struct Compute_cotangent
  {
    FT operator()(const Face& f, const Edge& ij, const Edge& jk, const Edge& ki) const
    {
      return FT((jk.hidden() + ki.hidden() - ij.hidden()) / f.hidden());
    }
  };

  Construct_edge_data construct_edge_data_object() const { return {}; }
  Construct_face_data construct_face_data_object() const { return {}; }
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
  Compute_squared_length compute_squared_length_object() const { return {}; }
  Compute_length compute_length_object() const { return {}; }
  Compute_area compute_area_object() const { return {}; }
  Compute_cotangent compute_cotangent_object() const { return {}; }
};

class Visitor
{
public:
  explicit Visitor(std::uint64_t limit) : limit_(limit) {}
  Visitor(const Visitor&) = default;
  Visitor& operator=(const Visitor&) = delete;

  bool go_further(const IT::Progress& progress) { return progress.tests < limit_; }
  void after_flip(IT::Edge_index) { ++flips; }

  std::uint64_t flips = 0;

private:
  std::uint64_t limit_;
};

// From edges to bool, read only.
struct Nothing_is_constrained
{
  using category = boost::readable_property_map_tag;
  using key_type = IT::Edge_index;
  using value_type = bool;
  using reference = bool;
  friend bool get(const Nothing_is_constrained&, IT::Edge_index) { return false; }
};

} // namespace archetype

namespace CGAL {

template <class Boolean>
class Real_embeddable_traits<archetype::Number<Boolean>>
{
public:
  using Is_real_embeddable = Tag_true;
  struct To_double
  {
    using result_type = double;
    double operator()(const archetype::Number<Boolean>& x) const { return x.hidden(); }
  };
  struct To_interval
  {
    using result_type = std::pair<double, double>;
    result_type operator()(const archetype::Number<Boolean>& x) const { return {x.hidden(), x.hidden()}; }
  };
};

} // namespace CGAL

namespace {

template <class Boolean>
class Archetype : public testing::Test
{};
using Booleans = testing::Types<bool, CGAL::Uncertain<bool>>;
TYPED_TEST_SUITE(Archetype, Booleans);

// A long edge between two flat triangles, and the two other sides of the surface.
IT::Delta_complex double_kite()
{
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  return IT::make_Delta_complex_from_triangles(4, triangles);
}

} // namespace

TYPED_TEST(Archetype, intrinsic_triangulation_from_lengths_and_flips)
{
  using Traits = archetype::Traits<TypeParam>;
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  using FT = typename Traits::FT;
  const FT side(1.1);
  auto t = Triangulation::from_lengths(double_kite(), {FT(2), side, side, side, side}, Traits(0));
  const IT::Edge_index diagonal(0);
  EXPECT_DOUBLE_EQ(t.length(diagonal).hidden(), 2);
  EXPECT_DOUBLE_EQ(t.squared_length(diagonal).hidden(), 4);
  EXPECT_LT(t.cotangent_weight(diagonal).hidden(), 0);
  EXPECT_FALSE(CGAL::possibly(t.is_locally_Delaunay(diagonal)));
  const double area = t.area(IT::Face_index(0)).hidden() + t.area(IT::Face_index(1)).hidden();

  Triangulation copy = t;
  archetype::Visitor visitor(1000);
  const IT::Flip_report report = IT::flip_to_Delaunay(t, CGAL::parameters::visitor(std::ref(visitor))
                                                           .edge_is_constrained_map(archetype::Nothing_is_constrained())
                                                           .maximum_number(std::uint64_t(5)));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_EQ(report.flips, 1u);
  EXPECT_EQ(visitor.flips, 1u);
  EXPECT_NEAR(t.length(diagonal).hidden(), 2 * std::sqrt(0.21), 1e-14);
  EXPECT_NEAR(t.area(IT::Face_index(0)).hidden() + t.area(IT::Face_index(1)).hidden(), area, 1e-14);
  EXPECT_GT(t.cotangent(t.connectivity().halfedge(diagonal)).hidden(), 0);

  EXPECT_EQ(copy.flip(diagonal), Triangulation::Flip_outcome::FLIPPED);
  EXPECT_EQ(IT::flip_to_Delaunay(copy).flips, 0u);
  EXPECT_THROW(IT::flip_to_Delaunay(copy, CGAL::parameters::visitor(archetype::Visitor(0))), IT::Cancelled_error);
}

TYPED_TEST(Archetype, bad_lengths_and_points_are_refused)
{
  using Traits = archetype::Traits<TypeParam>;
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  using FT = typename Traits::FT;
  const FT one(1);
  EXPECT_THROW(Triangulation::from_lengths(double_kite(), {FT(3), one, one, one, one}, Traits(0)),
               IT::Invalid_surface_error);
  const std::array<FT, 3> origin{FT(0), FT(0), FT(0)};
  EXPECT_THROW(Triangulation(double_kite(), {origin, origin, origin, origin}, Traits(0)), IT::Invalid_surface_error);
}

TYPED_TEST(Archetype, front_door)
{
  using Traits = archetype::Traits<TypeParam>;
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 2.);
  for (auto v : mesh.vertices())
    mesh.point(v) = Point(mesh.point(v).x(), 0.2 * mesh.point(v).y(), mesh.point(v).z());
  const auto [idt, report] = IT::intrinsic_Delaunay_triangulation(
    mesh, CGAL::parameters::geom_traits(Traits(0)).visitor(archetype::Visitor(100000)));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(report.flips, 0u);
}

// Lengths that an interval type cannot order are not a reason to throw.
TEST(Interval_lengths, may_overlap)
{
  using FT = CGAL::Interval_nt<>;
  const FT l(0.99, 1.01);
  const FT q = IT::squared_four_areas_from_lengths(l, l, l);
  EXPECT_LE(q.inf(), 3);
  EXPECT_GE(q.sup(), 3);
  using Traits = IT::Half_angle_traits<FT>;
  const auto t = IT::Intrinsic_triangulation<Traits>::from_lengths(double_kite(), {l, l, l, l, l});
  EXPECT_LE(t.area(IT::Face_index(0)).inf(), std::sqrt(3.) / 4);
  EXPECT_GE(t.area(IT::Face_index(0)).sup(), std::sqrt(3.) / 4);
}
