// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Copies all properties of one element of a Surface_mesh to another. The mesh knows the value type of a map only as
// std::type_info, so the type is looked for in a list.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_CARRIED_PROPERTIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_CARRIED_PROPERTIES_H

#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The mesh's map of this name, or something that converts to false: CGAL 5 returns a pair with a flag, CGAL 6 an
// optional map.
template <class Index, class Value, class SurfaceMesh>
auto find_property_map(const SurfaceMesh& mesh, const std::string& name)
{
  using Map = typename SurfaceMesh::template Property_map<Index, Value>;
  const auto found = mesh.template property_map<Index, Value>(name);
  if constexpr (std::is_same<decltype(found), const std::pair<Map, bool>>::value)
    return found.first;
  else
    return found.value_or(Map());
}

// Empty if the points belong to no kernel.
template <class Kernel, class = void>
struct Kernel_values
{
  using type = std::tuple<>;
};
template <class Kernel>
struct Kernel_values<Kernel, std::void_t<typename Kernel::Vector_2>>
{
  using type = std::tuple<typename Kernel::FT, typename Kernel::Point_2, typename Kernel::Point_3,
                          typename Kernel::Vector_2, typename Kernel::Vector_3>;
};

template <class Number>
using Number_arrays = std::tuple<std::array<Number, 2>, std::array<Number, 3>, std::array<Number, 4>>;

template <class Mesh>
using Known_values = decltype(std::tuple_cat(
  std::tuple<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned int, long, unsigned long,
             long long, unsigned long long, float, double, long double, std::string, Surface_point, CGAL::IO::Color,
             typename Mesh::Vertex_index, typename Mesh::Halfedge_index, typename Mesh::Edge_index,
             typename Mesh::Face_index>(),
  Number_arrays<float>(), Number_arrays<double>(), Number_arrays<std::int32_t>(), Number_arrays<std::uint32_t>(),
  typename Kernel_values<CGAL::Simple_cartesian<double>>::type(),
  typename Kernel_values<typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel>::type()));

// \tparam Index Mesh::Halfedge_index or Mesh::Face_index
// \tparam Value types to look for besides the known ones
template <class Mesh, class Index, class... Value>
class Carried_properties
{
public:
  // \exception std::invalid_argument if a map has another value type
  Carried_properties(const Mesh& mesh, const char* elements)
  {
    for (const std::string& name : mesh.template properties<Index>()) {
      const bool is_of_the_mesh = name == "h:connectivity" || name == "f:connectivity" || name == "f:removed";
      if (!is_of_the_mesh && !(add<Value>(mesh, name) || ...) &&
          !add_known(mesh, name, static_cast<Known_values<Mesh>*>(nullptr)))
        throw std::invalid_argument(
          "the property map \"" + name + "\" of " + elements +
          " has a value type that is not known: name it as a template argument of the function");
    }
  }

  // Copies all properties of `from` to `to`.
  void copy(Index from, Index to) const
  {
    for (const auto& copy_one : copies_)
      copy_one(from, to);
  }

private:
  template <class... Known>
  bool add_known(const Mesh& mesh, const std::string& name, const std::tuple<Known...>*)
  {
    return (add<Known>(mesh, name) || ...);
  }

  template <class T>
  bool add(const Mesh& mesh, const std::string& name)
  {
    const auto map = find_property_map<Index, T>(mesh, name);
    if (!map)
      return false;
    copies_.push_back([map](Index from, Index to) {
      const T value = map[from];
      map[to] = value;
    });
    return true;
  }

  std::vector<std::function<void(Index, Index)>> copies_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_CARRIED_PROPERTIES_H
