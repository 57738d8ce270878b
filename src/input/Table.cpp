// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Table.h"

#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include <cmath>
#include <cstdlib>

namespace idt {

Table::Table(const std::string& path, const std::string& other_separators)
  : path_(path), other_separators_(other_separators), file_(path)
{
  if (!file_)
    fail("the file cannot be opened");
}

bool Table::next()
{
  for (std::string text; std::getline(file_, text);) {
    if (++line_ == 1 && text.compare(0, 3, "\xef\xbb\xbf") == 0) // the byte order mark of spreadsheets
      text.erase(0, 3);
    if (!text.empty() && text.back() == '\r')
      text.pop_back();
    if (text.empty() || text[0] == '#')
      continue;
    if (other_separators_.empty() || text.find(',') != std::string::npos)
      boost::split(cells_, text, [](char c) { return c == ','; });
    else
      boost::split(cells_, text, boost::is_any_of(other_separators_), boost::token_compress_on);
    return true;
  }
  if (file_.bad())
    fail("the file cannot be read");
  if (line_ == 0)
    line_ = 1; // an empty file ends in its first line
  return false;
}

bool Table::has_names() const { return line_ == 1 && cells_[0].find_first_not_of("0123456789 ") != std::string::npos; }

double Table::real(std::size_t i) const
{
  if (i >= cells_.size())
    fail("a number is missing");
  char* end = nullptr;
  const double x = std::strtod(cells_[i].c_str(), &end);
  if (end == cells_[i].c_str() || *end != '\0')
    fail(quoted(cells_[i]) + " is no number");
  return x;
}

double Table::number(std::size_t i) const
{
  const double x = real(i);
  if (!std::isfinite(x))
    fail(quoted(cells_[i]) + " is no finite number");
  return x;
}

std::uint64_t Table::whole(std::size_t i) const
{
  const double x = number(i);
  if (!(x >= 0 && x < 0x1p53) || x != std::floor(x))
    fail(quoted(cells_[i]) + " is no whole number");
  return std::uint64_t(x);
}

void Table::require_size(std::size_t number_of_names) const
{
  if (cells_.size() != number_of_names)
    fail("there are " + std::to_string(number_of_names) + " names and " + counted(cells_.size(), "cell", "cells"));
}

void Table::fail(const std::string& what) const
{
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, line_, 1,
                              path_ + (line_ > 0 ? ", line " + std::to_string(line_) : std::string()) + ": " + what);
}

} // namespace idt
