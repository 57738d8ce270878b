# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The sources of read_surface(), for whoever reads files beside the command.

set(surface_reader read_surface.cpp
  formats/check_file.cpp formats/check_obj.cpp formats/check_off.cpp formats/check_ply.cpp
  formats/check_stl.cpp formats/check_ts.cpp
  formats/diagnose_by_position.cpp formats/text_file.cpp)
list(TRANSFORM surface_reader PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
