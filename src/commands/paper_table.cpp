// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/paper_table.h"

namespace idt {

const Paper_row* find_paper_row(const std::string& model, std::uint64_t vertices)
{
  static const Paper_row rows[] = {
    {"cathead", 131, 45, 40, 3, 0.8114, {}},
    {"bunnyhead", 741, 380, 275, 6, 0.6139, {}},
    {"beautiful_freak", 1042, 560, 364, 12, 0.1841, {}},
    {"hygeia", 8268, 4017, 2861, 6, 0.1053, {}},
    {"planck", 25445, 6417, 5584, 5, 0.7746, 7167},
    {"bunny", 34834, 2365, 2283, 4, 0.0758, 2434},
    {"camel", 40240, 17074, 12618, 22, 0.7218, 25043},
    {"horse", 48485, 3581, 3127, 7, 0.6734, 4027},
    {"feline", 49864, 12178, 10767, 7, 0.5746, 13317},
  };
  for (const Paper_row& row : rows)
    if (row.model == model && row.vertices == vertices)
      return &row;
  return nullptr;
}

} // namespace idt
