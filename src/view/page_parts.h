// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of the page, which CMake takes from the files of this folder.

#ifndef IDT_PAGE_PARTS_H
#define IDT_PAGE_PARTS_H

namespace idt {

extern const char* const page_html;
extern const char* const page_script;
extern const char* const page_three; // empty if three.js was not there

} // namespace idt

#endif // IDT_PAGE_PARTS_H
