// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The sides of laid out faces: which of them meet, and in which order.

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

double Laid_out_faces::longest_side() const
{
  double result = 0;
  for (const Side& side : sides_)
    result = (std::max)(result, side.length);
  return result;
}

bool Laid_out_faces::is_before(std::uint32_t i, std::uint32_t j) const
{
  for (int corner = 0; corner < 3; ++corner, i = next(i), j = next(j)) {
    const std::uint32_t v = sides_[i].row, w = sides_[j].row;
    if (v != w)
      return places_.is_before(v, w);
  }
  return i < j;
}

Face_apex Laid_out_faces::apex_of_flat_face(const std::array<double, 3>& length)
{
  const double sum = length[1] + length[2];
  return {length[2] / sum, length[1] / sum, 0x1p-40};
}

void Laid_out_faces::add_face(const Corners& corners, const std::array<double, 3>& length, const Face_apex& apex)
{
  const double x = apex.x * length[0], rest = apex.rest * length[0], height = apex.height * length[0];
  // The scalar product of the two sides at each corner.
  const std::array<double, 3> dot{x * length[0], rest * length[0], height * height - x * rest};
  const double cross = height * length[0];
  for (int i = 0; i < 3; ++i) {
    Side side;
    std::tie(side.vertex, side.row) = corners[i];
    side.length = length[i];
    side.apex_x = dot[i] / length[i];
    side.apex_y = cross / length[i];
    side.angle = std::atan2(cross, dot[i]);
    angle_sums_[side.vertex] += std::int64_t(side.angle * angle_scale);
    sides_.push_back(side);
  }
}

void Laid_out_faces::join_cut_sides()
{
  std::vector<std::array<std::uint32_t, 3>> cut; // two rows, and the side between them
  for (std::uint32_t i = 0; i < sides_.size(); ++i)
    if (sides_[i].opposite == none)
      cut.push_back(
        {(std::min)(sides_[i].row, sides_[next(i)].row), (std::max)(sides_[i].row, sides_[next(i)].row), i});
  std::sort(cut.begin(), cut.end(), [this](const auto& a, const auto& b) {
    return std::make_pair(a[0], a[1]) != std::make_pair(b[0], b[1]) ? a < b : is_before(a[2], b[2]);
  });
  beside_.assign(sides_.size(), none);
  for (std::size_t i = 0, j; i < cut.size(); i = j) {
    for (j = i + 1; j < cut.size() && cut[j][0] == cut[i][0] && cut[j][1] == cut[i][1]; ++j)
      beside_[cut[j - 1][2]] = cut[j][2];
    if (j > i + 1)
      beside_[cut[j - 1][2]] = cut[i][2];
  }
}

// Sides along which a face is so thin that ways can circle a needle again and again before they meet a corner.
void Laid_out_faces::number_narrow_edges()
{
  for (std::uint32_t i = 0; i < sides_.size(); ++i) {
    if (sides_[i].narrow != none || !(sides_[i].apex_y < sides_[i].length / 16))
      continue;
    const std::uint32_t edge = 2 * std::uint32_t(number_of_narrow_edges_++);
    sides_[i].narrow = edge;
    if (sides_[i].opposite != none)
      sides_[sides_[i].opposite].narrow = edge + 1;
    for (std::uint32_t j = beside(i); j != none && j != i; j = beside(j))
      sides_[j].narrow = edge + (sides_[j].row == sides_[i].row ? 0 : 1);
  }
}

void Laid_out_faces::index_corners()
{
  for (const Side& side : sides_) {
    ++first_[side.row + 1];
    if (side.opposite == none)
      angle_sums_[side.vertex] = angle_sums_[sides_[next(std::uint32_t(&side - sides_.data()))].vertex] = -1;
  }
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    first_[v + 1] += first_[v];
  corners_.resize(sides_.size());
  std::vector<std::uint32_t> position(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < sides_.size(); ++i)
    corners_[position[sides_[i].row]++] = std::uint32_t(i);
  // If two ways along edges reach the same row at once, the first one counts.
  for (std::size_t row = 0; row + 1 < first_.size(); ++row) {
    const std::uint32_t begin = first_[row], end = first_[row + 1];
    if (end - begin > 16 || has_edges_to_same_row(begin, end))
      std::sort(corners_.begin() + begin, corners_.begin() + end,
                [this](std::uint32_t i, std::uint32_t j) { return is_before(i, j); });
  }
}

void Laid_out_faces::add_flat_edge(std::uint32_t v, std::uint32_t w, double length)
{
  for (const std::uint32_t row : {v, w, v}) {
    Side side;
    side.vertex = side.row = row;
    side.length = length;
    sides_.push_back(side);
  }
  flat_edges_.push_back({v, std::uint32_t(sides_.size() - 3)});
  flat_edges_.push_back({w, std::uint32_t(sides_.size() - 2)});
}

void Laid_out_faces::index_flat_edges()
{
  std::sort(flat_edges_.begin(), flat_edges_.end(), [this](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : is_before(a.second, b.second);
  });
  if (!beside_.empty())
    beside_.resize(sides_.size(), none);
}

bool Laid_out_faces::has_edges_to_same_row(std::uint32_t begin, std::uint32_t end) const
{
  for (std::uint32_t i = begin; i != end; ++i)
    for (std::uint32_t j = begin; j != i; ++j)
      if (sides_[prev(corners_[i])].row == sides_[prev(corners_[j])].row)
        return true;
  return std::any_of(corners_.begin() + begin, corners_.begin() + end,
                     [this](std::uint32_t side) { return sides_[side].opposite == none; });
}

} // namespace CGAL::Intrinsic_triangulations::internal
