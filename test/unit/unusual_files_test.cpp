// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of unusual and damaged files, each small and large: read with all faces, perhaps with a warning, or refused
// at the right place.

#include "Surface_file_test.h"
#include "faces_of_file.h"
#include "valid_files.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

// The expected outcome for a file: all faces unless there is an error.
struct Expected
{
  std::string error, warning;
  std::size_t faces = 0;
};

// A sheet, and the places of its elements in the files of valid_files.h.
struct Sheet_in_files : Sheet
{
  using Sheet::Sheet;
  std::size_t v() const { return points.size(); }
  std::size_t f() const { return triangles.size(); }
  std::size_t middle() const { return f() / 2; } // a face
  // Lines, counted from 1
  std::size_t off_vertex(std::size_t i) const { return 3 + i; }
  std::size_t off_face(std::size_t i) const { return 3 + v() + i; }
  std::size_t obj_face(std::size_t i) const { return 8 + v() + i; }
  std::size_t ts_vertex(std::size_t i) const { return 6 + i; }
  std::size_t ts_face(std::size_t i) const { return 6 + v() + i; }
  std::size_t ply_vertex(std::size_t i) const { return 12 + i; }
  std::size_t ply_face(std::size_t i) const { return 12 + v() + i; }
  static std::size_t stl_facet(std::size_t i) { return 2 + 7 * i; }
};

// "line 7 (face 3)"
std::string at(std::size_t line, const std::string& kind, std::size_t element)
{
  return "line " + std::to_string(line) + " (" + kind + " " + std::to_string(element) + ")";
}
std::string ply_at(std::size_t line, const std::string& kind, std::size_t element)
{
  return "line " + std::to_string(line) + ", element " + kind + " " + std::to_string(element);
}

std::string at_line_with_cr(std::size_t line) { return "line " + std::to_string(line) + ": a CR ends the comment"; }

// Where a line begins, counted from 1.
std::size_t begin_of_line(const std::string& text, std::size_t line)
{
  std::size_t begin = 0;
  while (--line > 0)
    begin = text.find('\n', begin) + 1;
  return begin;
}
std::string with_line(std::string text, std::size_t line, const std::function<std::string(std::string)>& change)
{
  const std::size_t begin = begin_of_line(text, line), size = text.find('\n', begin) - begin;
  return text.replace(begin, size, change(text.substr(begin, size)));
}
std::string with_line(const std::string& text, std::size_t line, const std::string& other)
{
  return with_line(text, line, [&](const std::string&) { return other; });
}
std::string without_line(std::string text, std::size_t line)
{
  const std::size_t begin = begin_of_line(text, line);
  return text.erase(begin, text.find('\n', begin) + 1 - begin);
}
std::string doubled(const std::string& text, std::size_t line)
{
  return with_line(text, line, [](const std::string& l) { return l + "\n" + l; });
}
std::string appended(const std::string& text, std::size_t line, const std::string& more)
{
  return with_line(text, line, [&](const std::string& l) { return l + more; });
}
std::string replaced(const std::string& text, const std::string& from, const std::string& to)
{
  std::string result;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = text.find(from, begin)) != std::string::npos; begin = at + from.size())
    result.append(text, begin, at - begin).append(to);
  return result.append(text, begin, std::string::npos);
}
// With a header that announces other numbers.
std::string off_with_counts(const Sheet_in_files& s, std::size_t v, std::size_t f)
{
  return with_line(off_text(s), 2, std::to_string(v) + " " + std::to_string(f) + " 0");
}
std::string ply_with_count(const std::string& text, const std::string& element, std::size_t from, std::size_t to)
{
  return replaced(text, "element " + element + " " + std::to_string(from) + "\n",
                  "element " + element + " " + std::to_string(to) + "\n");
}
// Of a binary file, before the others.
std::string with_empty_face(const Sheet_in_files& s, std::string text)
{
  text.insert(text.find("end_header\n") + 11 + 12 * s.v(), 1, '\0');
  return ply_with_count(text, "face", s.f(), s.f() + 1);
}
std::string strips(const Sheet_in_files& s, const std::string& format, const std::string& type,
                   const std::string& more = "")
{
  std::string text = ply_text(s, {format, "float", "uchar", "int", "", "vertex_indices"});
  const std::size_t header = text.find("element face"), end = text.find("end_header\n") + 11,
                    body = end + (format == "ascii" ? 0 : 12 * s.v());
  std::string vertices =
    format == "ascii" ? text.substr(end, begin_of_line(text, s.ply_face(0)) - end) : text.substr(end, body - end);
  std::string list = more;
  Ply_form form;
  form.format = format;
  std::size_t entries = more.empty() ? 0 : std::size_t(std::count(more.begin(), more.end(), ' '));
  for (const auto& t : s.triangles)
    for (const double x : {double(t[0]), double(t[1]), double(t[2]), -1.}) {
      append_ply_number(list, x, type, form);
      ++entries;
    }
  std::string count = "\n";
  append_ply_number(count, double(entries), "int", form);
  return text.substr(0, header) + "element tristrips 1\nproperty list int " + type + " vertex_indices\nend_header\n" +
         vertices + count.substr(1) + list + (format == "ascii" ? "\n" : "");
}

struct Case
{
  const char* extension;
  const char* what;
  std::function<std::string(const Sheet_in_files&, Expected&)> make;
};
using S = const Sheet_in_files;
using E = Expected;

std::vector<Case> cases()
{
  return {
    // ---- text STL
    {"stl", "a capital in one line",
     [](S& s, E&) { return with_line(stl_text(s), s.stl_facet(s.middle()), "Facet normal 0 0 1"); }},
    {"stl", "END SOLID", [](S& s, E&) { return replaced(stl_text(s), "endsolid", "END SOLID"); }},
    {"stl", "end loop, end facet",
     [](S& s, E&) { return replaced(replaced(stl_text(s), "endloop", "end loop"), "endfacet", "end facet"); }},
    {"stl", "a tab behind solid", [](S& s, E&) { return replaced(stl_text(s), "solid ", "solid\t"); }},
    {"stl", "tabs and blanks", [](S& s, E&) { return replaced(stl_text(s), " ", " \t "); }},
    {"stl", "byte order mark", [](S& s, E&) { return "\xef\xbb\xbf" + stl_text(s); }},
    {"stl", "CR alone", [](S& s, E&) { return replaced(stl_text(s), "\n", "\r"); }},
    {"stl", "one line", [](S& s, E&) { return replaced(stl_text(s), "\n", " "); }},
    {"stl", "several solids in one line",
     [](S& s, E& e) {
       e.faces = 2 * s.f();
       return replaced(stl_text(s) + stl_text(s), "\n", " ");
     }},
    {"stl", "one line, no solid behind endsolid",
     [](S& s, E& e) {
       e.error = at(1, "facet", s.f()) + ": \"facet normal\" where solid is expected";
       return replaced(stl_text(s) + without_line(stl_text(s), 1), "\n", " ");
     }},
    {"stl", "one line, colors everywhere",
     [](S& s, E&) {
       return replaced(replaced(replaced(stl_text(s), "\n", " "), "outer", "color 1 0 0 outer"), "endfacet",
                       "color 1 0.5 0 1 endfacet colour 1 1 1");
     }},
    {"stl", "one line, a facet misspelt behind a color",
     [](S& s, E& e) {
       e.error = at(1, "facet", s.middle()) + ": \"normal\" where facet or endsolid is expected";
       return replaced(with_line(stl_text(s), s.stl_facet(s.middle()), "color 1 0 0 facett normal 0 0 1"), "\n", " ");
     }},
    {"stl", "names, comments and colors that look like words of facets",
     [](S& s, E&) {
       return replaced(with_line(stl_text(s), 1,
                                 "solid Front end facet\n# color\r# more, and\rthe end facet\ncolor red\n"
                                 "color = (1, 0, 0)"),
                       "outer loop", "# the outer loop follows\nouter loop");
     }},
    {"stl", "one line, a comment",
     [](S& s, E& e) {
       e.error = at(1, "facet", s.middle()) + ": \"loop\" is in the comment that begins with # on this line";
       return replaced(with_line(stl_text(s), s.stl_facet(s.middle()), "# middle facet normal 0 0 1"), "\n", " ");
     }},
    {"stl", "a facet that is a comment",
     [](S& s, E&) {
       return with_line(stl_text(s), 1, "solid\n # facet normal 0 0 1 outer loop vertex 0 0 0 endloop endfacet");
     }},
    {"stl", "one line, facett at first, end loop",
     [](S& s, E& e) {
       e.error = at(1, "facet", 0) + ": \"loop\" where facet or endsolid is expected";
       return replaced(replaced(with_line(stl_text(s), 2, "facett normal 0 0 1"), "\n", " "), "end", "end ");
     }},
    {"stl", "a comment that ends as no other line",
     [](S& s, E& e) {
       e.error = "line 2: a CR ends the comment, but lines end with LF before it";
       return with_line(stl_text(s), 1, "solid\n# a comment \r facet normal 0 0 1\r");
     }},
    {"stl", "normals that are NaN or missing",
     [](S& s, E&) {
       return replaced(with_line(stl_text(s), s.stl_facet(s.middle()), "facet normal"), "normal 0 0 1",
                       "normal nan -nan(ind) 1.#QNAN");
     }},
    {"stl", "colors and comments",
     [](S& s, E&) {
       return replaced(replaced(stl_text(s), "outer", "color 1 0 0\nouter"), "endloop", "endloop # facet");
     }},
    {"stl", "no endsolid",
     [](S& s, E& e) {
       e.warning = "without a line endsolid, behind facet " + std::to_string(s.f() - 1);
       return replaced(stl_text(s), "endsolid sheet\n", "");
     }},
    {"stl", "no endsolid before another solid",
     [](S& s, E& e) {
       e.warning = "line " + std::to_string(s.stl_facet(s.f())) + ": a solid begins";
       e.faces = 2 * s.f();
       return replaced(stl_text(s), "endsolid sheet\n", "") + stl_text(s);
     }},
    {"stl", "several solids, named as facets",
     [](S& s, E& e) {
       e.faces = 2 * s.f();
       return stl_text(s) + replaced(stl_text(s), "solid sheet", "solid facet normal");
     }},
    {"stl", "no facet normal",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()), "facet", s.middle()) +
                 ": \"outer\" where facet or endsolid is expected: the line facet normal is missing";
       return without_line(stl_text(s), s.stl_facet(s.middle()));
     }},
    {"stl", "no outer loop",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 4, "facet", s.middle()) + ": \"endloop\" where endfacet";
       return without_line(stl_text(s), s.stl_facet(s.middle()) + 1);
     }},
    {"stl", "no vertex",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 5, "facet", s.middle()) + ": the facet does not have three";
       return without_line(stl_text(s), s.stl_facet(s.middle()) + 2);
     }},
    {"stl", "four vertices",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 5, "facet", s.middle()) + ": the facet does not have three";
       return doubled(stl_text(s), s.stl_facet(s.middle()) + 2);
     }},
    {"stl", "no endloop",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 5, "facet", s.middle()) + ": \"endfacet\" where endloop";
       return without_line(stl_text(s), s.stl_facet(s.middle()) + 5);
     }},
    {"stl", "no endfacet",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 6, "facet", s.middle()) + ": \"facet\" where endfacet";
       return without_line(stl_text(s), s.stl_facet(s.middle()) + 6);
     }},
    {"stl", "facetnormal",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()), "facet", s.middle()) + ": \"facetnormal\" where facet or";
       return with_line(stl_text(s), s.stl_facet(s.middle()), "facetnormal 0 0 1");
     }},
    {"stl", "face normal",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()), "facet", s.middle()) + ": \"face\" where facet or";
       return with_line(stl_text(s), s.stl_facet(s.middle()), "face normal 0 0 1");
     }},
    {"stl", "one line, facett at first",
     [](S& s, E& e) {
       e.error = at(1, "facet", 0) + ": \"loop\" where facet or endsolid is expected: the line facet normal is missing";
       return replaced(with_line(stl_text(s), 2, "facett normal 0 0 1"), "\n", " ");
     }},
    {"stl", "vertx",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 3, "facet", s.middle()) + ": \"vertx\" where vertex";
       return with_line(stl_text(s), s.stl_facet(s.middle()) + 3, "vertx 0 0 0");
     }},
    {"stl", "two numbers",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 3, "facet", s.middle()) + ": a vertex has 2 numbers";
       return with_line(stl_text(s), s.stl_facet(s.middle()) + 3, "vertex 0 0");
     }},
    {"stl", "four numbers",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 3, "facet", s.middle()) + ": \"4\" where vertex";
       return with_line(stl_text(s), s.stl_facet(s.middle()) + 3, "vertex 0 0 0 4");
     }},
    {"stl", "a vertex that is NaN",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 3, "facet", s.middle()) + ": the coordinate \"nan\" is not finite";
       return with_line(stl_text(s), s.stl_facet(s.middle()) + 3, "vertex 0 nan 0");
     }},
    {"stl", "no line solid",
     [](S& s, E& e) {
       e.error = "the first word is \"facet\" and not solid";
       return without_line(stl_text(s), 1);
     }},
    {"stl", "endsolid in the middle",
     [](S& s, E& e) {
       e.error = at(s.stl_facet(s.middle()) + 1, "facet", s.middle()) + ": \"facet\" where solid";
       return with_line(stl_text(s), s.stl_facet(s.middle()), "endsolid\nfacet normal 0 0 1");
     }},
    {"stl", "cut off",
     [](S& s, E& e) {
       e.error = "the file ends within facet " + std::to_string(s.middle());
       const std::string t = stl_text(s);
       return t.substr(0, begin_of_line(t, s.stl_facet(s.middle()) + 3));
     }},
    // ---- binary STL
    {"stl", "attributes", [](S& s, E&) { return stl_bytes(s, "COLOR=\xff\x10", std::uint32_t(s.f()), 0x8123); }},
    {"stl", "a header that begins with solid",
     [](S& s, E&) { return stl_bytes(s, "solid facet normal", std::uint32_t(s.f())); }},
    {"stl", "count 0",
     [](S& s, E& e) {
       e.warning = "the header announces 0 facets; all " + s.number_of_faces();
       return stl_bytes(s, "x", 0);
     }},
    {"stl", "count 0, cut off",
     [](S& s, E& e) {
       e.error = "it ends within facet " + std::to_string(s.f() - 1);
       std::string b = stl_bytes(s, "x", 0);
       b.pop_back();
       return b;
     }},
    {"stl", "count -1",
     [](S& s, E& e) {
       e.warning = "the header announces 4294967295 facets; all " + s.number_of_faces();
       return stl_bytes(s, "x", 4294967295u);
     }},
    {"stl", "count too small",
     [](S& s, E& e) {
       e.error = "facet " + std::to_string(s.f() - 1) + ", at byte " + std::to_string(84 + 50 * (s.f() - 1)) +
                 ", is the first behind them";
       return stl_bytes(s, "x", std::uint32_t(s.f() - 1));
     }},
    {"stl", "count too large",
     [](S& s, E& e) {
       e.error =
         "it ends within facet " + s.number_of_faces() + ", which begins at byte " + std::to_string(84 + 50 * s.f());
       return stl_bytes(s, "x", std::uint32_t(s.f() + 1));
     }},
    {"stl", "bytes behind the facets",
     [](S& s, E& e) {
       e.warning = "there are 3 bytes behind the " + s.number_of_faces() + " facets";
       return stl_bytes(s, "x", std::uint32_t(s.f())) + "\n\n\n";
     }},
    {"stl", "a facet behind the facets",
     [](S& s, E& e) {
       e.error = "facet " + s.number_of_faces() + ", at byte";
       const std::string b = stl_bytes(s, "x", std::uint32_t(s.f()));
       return b + b.substr(84, 50);
     }},
    {"stl", "a binary file cut off",
     [](S& s, E& e) {
       e.error = "it ends within facet " + std::to_string(s.f() - 1);
       std::string b = stl_bytes(s, "solid x", std::uint32_t(s.f()));
       b.pop_back();
       return b;
     }},
    // ---- OFF
    {"off", "OFF4 4 0", [](S& s, E&) { return off_text(s, "OFF"); }},
    {"off", "off in small letters", [](S& s, E&) { return off_text(s, "off\n"); }},
    {"off", "counts on three lines",
     [](S& s, E&) {
       return with_line(off_text(s), 2, s.number_of_points() + " # vertices\n\n" + s.number_of_faces() + "\n0");
     }},
    {"off", "comments everywhere",
     [](S& s, E&) { return replaced(off_text(s, "# 3\nOFF # 4\n# 5\n"), "\n", " # 3 0 1 2\n#\n\n"); }},
    {"off", "faces over several lines",
     [](S& s, E&) {
       return with_line(off_text(s), s.off_face(s.middle()),
                        [](const std::string& l) { return replaced(l, " ", "\n"); });
     }},
    {"off", "NOFF", [](S& s, E&) { return off_text(s, "NOFF\n", " 0 0 1"); }},
    {"off", "COFF, floats", [](S& s, E&) { return off_text(s, "COFF\n", " 0.5 0.5 0.5 1"); }},
    {"off", "COFF, opacity of one",
     [](S& s, E&) { return appended(off_text(s, "COFF\n", " 0.5 0.5 0.5"), s.off_vertex(1), " 1"); }},
    {"off", "COFF, a face as a vertex",
     [](S& s, E& e) {
       e.error = at(s.off_face(0), "vertex", s.v()) + ": there are 4 numbers where the vertices before have 6";
       return with_line(off_text(s, "COFF\n", " 0.5 0.5 0.5"), 2,
                        std::to_string(s.v() + 1) + " " + std::to_string(s.f() - 1) + " 0");
     }},
    {"off", "STOFF", [](S& s, E&) { return off_text(s, "STOFF\n", " 0.5 0.5"); }},
    {"off", "CNOFF", [](S& s, E&) { return off_text(s, "CNOFF\n", " 0 0 1 255 255 255"); }},
    {"off", "NCSTOFF", [](S& s, E&) { return off_text(s, "NCSTOFF\n", " 0 0 1 255 255 255 255 0.5 0.5"); }},
    {"off", "4OFF", [](S& s, E&) { return off_text(s, "4OFF\n", " 2"); }},
    {"off", "4OFF, a quotient out of range",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(1), "vertex", 1) + ": divided by the fourth coordinate, another is too large";
       return with_line(off_text(s, "4OFF\n", " 2"), s.off_vertex(1), "1 0 0 1e-310");
     }},
    {"off", "nOFF of dimension 3", [](S& s, E&) { return off_text(s, "nOFF\n3\n"); }},
    {"off", "nOFF of dimension 5",
     [](S& s, E& e) {
       e.error = "points of \"5\" coordinates are not read";
       return off_text(s, "nOFF\n5\n", " 0 0");
     }},
    {"off", "colors without C", [](S& s, E&) { return off_text(s, "OFF\n", " 255 0 0"); }},
    {"off", "colors of faces",
     [](S& s, E&) { return appended(off_text(s, "OFF\n", "", " 0.1 0.2 0.3"), s.off_face(s.middle()), " 1"); }},
    {"off", "a byte order mark and CR LF",
     [](S& s, E&) { return "\xef\xbb\xbf" + replaced(off_text(s), "\n", "\r\n"); }},
    {"off", "CR alone", [](S& s, E&) { return replaced(off_text(s), "\n", "\r"); }},
    {"off", "a comment with CR and words",
     [](S& s, E&) { return appended(off_text(s), 1, " # a sheet\r3 of 4 points\r-- f as\rv of 3\r 12 mm"); }},
    {"off", "a comment with CR and a face",
     [](S& s, E& e) {
       e.error = at_line_with_cr(s.off_face(0));
       return appended(off_text(s), s.off_face(0), " # a\r3 0 1 2");
     }},
    {"off", "binary",
     [](S&, E& e) {
       e.error = "binary OFF is not read";
       return std::string("OFF BINARY\n\0\0\0\4", 15);
     }},
    {"off", "no number of edges",
     [](S& s, E& e) {
       e.error = "line 3: \"500e-3\" is not a number of edges";
       return with_line(off_text(s), 2, s.number_of_points() + " " + s.number_of_faces());
     }},
    {"off", "fewer faces announced",
     [](S& s, E& e) {
       e.error = at(s.off_face(s.f() - 1), "face", s.f() - 1) + ": \"3 ";
       return off_with_counts(s, s.v(), s.f() - 1);
     }},
    {"off", "more faces announced",
     [](S& s, E& e) {
       e.error = "the file ends after " + s.number_of_faces() + " of " + std::to_string(s.f() + 1) + " faces";
       return off_with_counts(s, s.v(), s.f() + 1);
     }},
    {"off", "more vertices announced",
     [](S& s, E& e) {
       e.error = at(s.off_face(0), "vertex", s.v()) +
                 ": there are 4 numbers where the vertices before have 3; the header announces";
       return off_with_counts(s, s.v() + 1, s.f());
     }},
    {"off", "fewer vertices announced",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(s.v() - 1), "face", 0) + ": ";
       return off_with_counts(s, s.v() - 1, s.f());
     }},
    {"off", "a vertex missing",
     [](S& s, E& e) {
       e.error = at(s.off_face(0) - 1, "vertex", s.v() - 1) + ": there are 4 numbers";
       return without_line(off_text(s), s.off_vertex(s.v() / 2));
     }},
    {"off", "a face missing",
     [](S& s, E& e) {
       e.error = "the file ends after " + std::to_string(s.f() - 1) + " of " + s.number_of_faces();
       return without_line(off_text(s), s.off_face(s.middle()));
     }},
    {"off", "a face doubled",
     [](S& s, E& e) {
       e.error = at(s.off_face(s.f()), "face", s.f()) + ": \"3 ";
       return doubled(off_text(s), s.off_face(s.middle()));
     }},
    {"off", "a coordinate missing",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(s.v() / 2), "vertex", s.v() / 2) + ": there are 2 numbers where 3";
       return with_line(off_text(s), s.off_vertex(s.v() / 2), "1 2");
     }},
    {"off", "a corner missing",
     [](S& s, E& e) {
       e.error = at(s.off_face(s.middle()), "face", s.middle()) + ": there are 2 vertices where 3";
       return with_line(off_text(s), s.off_face(s.middle()), "3 1 2");
     }},
    {"off", "words behind a vertex",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(1), "vertex", 1) + ": \"red\" is behind";
       return appended(off_text(s), s.off_vertex(1), " red");
     }},
    {"off", "two faces in a line",
     [](S& s, E& e) {
       e.error = at(s.off_face(s.middle()), "face", s.middle()) + ": \"3\" is behind the numbers";
       return appended(off_text(s), s.off_face(s.middle()), " 1 2 3 4 3");
     }},
    {"off", "indices from 1",
     [](S& s, E& e) {
       e.error = "No face names vertex 0: the indices seem to count from 1";
       std::string t = off_text(s);
       t.resize(begin_of_line(t, s.off_face(0)));
       for (const auto& f : s.triangles)
         t += "3 " + text_of(f, 1) + "\n";
       return t;
     }},
    {"off", "a vertex that is NaN",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(1), "vertex", 1) + ": the coordinate \"nan\" is not finite";
       return with_line(off_text(s), s.off_vertex(1), "1 nan 0");
     }},
    {"off", "a vertex that is NaN and has no face",
     [](S& s, E& e) {
       e.error = at(s.off_vertex(s.v()), "vertex", s.v()) + ": the coordinate \"nan\" is not finite";
       return appended(off_with_counts(s, s.v() + 1, s.f()), s.off_vertex(s.v() - 1), "\nnan 0 inf");
     }},
    // ---- OBJ
    {"obj", "faces that go on",
     [](S& s, E&) {
       return with_line(obj_text(s), s.obj_face(s.middle()),
                        [](const std::string& l) { return replaced(l, " ", "\\\n "); });
     }},
    {"obj", "vertices that go on",
     [](S& s, E&) {
       return with_line(obj_text(s), 3, [](const std::string& l) { return replaced(l, " ", " \\ \r\n"); });
     }},
    {"obj", "comments and others that go on",
     [](S& s, E&) { return "# a comment \\\n goes on\ng a \\\n b\n" + obj_text(s); }},
    {"obj", "a comment that ends as a path",
     [](S& s, E& e) {
       e.error = "line 3: \"v ";
       return with_line(obj_text(s), 2, "# C:\\models\\");
     }},
    {"obj", "capitals", [](S& s, E&) { return replaced(replaced(obj_text(s), "\nv ", "\nV "), "\nf ", "\nF\t"); }},
    {"obj", "weights and colors", [](S& s, E&) { return obj_text(s, " 1 0.5 0.5 0.5"); }},
    {"obj", "v/vt/vn", [](S& s, E&) { return obj_text(s, "", "/1/1"); }},
    {"obj", "v//vn", [](S& s, E&) { return obj_text(s, "", "//1"); }},
    {"obj", "negative indices",
     [](S& s, E&) {
       std::string t = obj_text(s);
       t.resize(begin_of_line(t, s.obj_face(0)));
       for (const auto& f : s.triangles) {
         t += "f";
         for (const std::uint32_t v : f)
           t += " -" + std::to_string(s.v() - v);
         t += "\n";
       }
       return t;
     }},
    {"obj", "lines, points, curves",
     [](S& s, E&) { return obj_text(s) + "l 1 2 3\np 1\ncstype bezier\ncurv 0 1 1 2 3\nend\nSHADOW_OBJ x\n"; }},
    {"obj", "faces before vertices",
     [](S& s, E&) {
       const std::string t = obj_text(s);
       return t.substr(begin_of_line(t, s.obj_face(0))) + t.substr(0, begin_of_line(t, s.obj_face(0)));
     }},
    {"obj", "a byte order mark", [](S& s, E&) { return "\xef\xbb\xbf" + obj_text(s); }},
    {"obj", "CR alone", [](S& s, E&) { return replaced(obj_text(s), "\n", "\r"); }},
    {"obj", "fc",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.obj_face(s.middle())) + ": \"fc 1 2 3\" is not understood";
       return with_line(obj_text(s), s.obj_face(s.middle()), "fc 1 2 3");
     }},
    {"obj", "f1",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.obj_face(s.middle())) + ": \"f1 2 3\" is not understood";
       return with_line(obj_text(s), s.obj_face(s.middle()), "f1 2 3");
     }},
    {"obj", "a vertex missing",
     [](S& s, E& e) {
       e.error = "the face names vertex " + s.number_of_points() + ", but there are " + std::to_string(s.v() - 1);
       return without_line(obj_text(s), 3);
     }},
    {"obj", "two vertices in a line",
     [](S& s, E& e) {
       e.error = at(3, "vertex", 0) + ": \"v\" is behind the coordinates";
       return with_line(obj_text(s), 3, "v 0 0 0 v 1 1 1");
     }},
    {"obj", "two faces in a line",
     [](S& s, E& e) {
       e.error = at(s.obj_face(s.middle()), "face", s.middle()) + ": \"f\" is not a corner";
       return with_line(obj_text(s), s.obj_face(s.middle()), "f 1 2 3 f 2 3 4");
     }},
    {"obj", "another file",
     [](S& s, E& e) {
       e.error = "line 1: \"call b.obj\" runs another file or program";
       return "call b.obj\n" + obj_text(s);
     }},
    {"obj", "a face behind another element",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.obj_face(0) - 1) + ": \"f\" is within another element";
       return with_line(obj_text(s), s.obj_face(0) - 1, "s off f 1 2 3");
     }},
    {"obj", "a vertex behind another element, with another line end",
     [](S& s, E& e) {
       e.error = "line 2: \"V\" is within another element";
       return with_line(obj_text(s), 2, "o sheet\rV -1 2 3");
     }},
    {"obj", "a face that has lost its line end",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.obj_face(0) - 1) + ": \"f\" is within another element";
       return with_line(obj_text(s), s.obj_face(0) - 1, "s offf 1 2 3");
     }},
    {"obj", "a vertex that has lost its line end",
     [](S& s, E& e) {
       e.error = "line 2: \"v\" is within another element";
       return with_line(obj_text(s), 2, "vt 0 0v 1 2 3");
     }},
    {"obj", "a comment that ends as no other line",
     [](S& s, E& e) {
       e.error = "line 1: a CR ends the comment";
       return with_line(obj_text(s), 1, "# a sheet\rf 1 2 3");
     }},
    {"obj", "a comment with CR and words",
     [](S& s, E&) { return with_line(obj_text(s), 1, "# a sheet\r3 of 4\rf is a face, v a vertex\r1 x 2 cm"); }},
    {"obj", "a comment with CR and a misspelt vertex",
     [](S& s, E& e) {
       e.error = at_line_with_cr(1);
       return with_line(obj_text(s), 1, "# a sheet\rv 1 o 3");
     }},
    {"obj", "names with f and v",
     [](S& s, E&) { return "o sheet v 1 2\ng f 1 2 f a 3 # f 1 2 3\nparm v 0 0 1\n" + obj_text(s); }},
    {"obj", "a name that looks like a face",
     [](S& s, E& e) {
       e.warning = "line 2: \"f\" is within another element";
       return with_line(obj_text(s), 2, "g wall f 1 2 3");
     }},
    {"obj", "names and comments that look a little like faces",
     [](S& s, E&) {
       return "# by x\r# page\rtwo\no Valve DN50 F 100x20 30x40 5mm\nusemtl v 3d 2d 1d\ng v -a -b -c\n" + obj_text(s);
     }},
    {"obj", "curved surfaces",
     [](S& s, E& e) {
       e.warning = "line 1: this and all other curved surfaces are left out";
       return "surf 0 1 0 1 1 2 3 4\nend\nbzp 1 2 3\n" + obj_text(s);
     }},
    {"obj", "index 0",
     [](S& s, E& e) {
       e.error =
         at(s.obj_face(s.middle()), "face", s.middle()) + ": \"0\" names vertex 0, but vertices are counted from 1";
       return with_line(obj_text(s), s.obj_face(s.middle()), "f 0 1 2");
     }},
    {"obj", "a vertex that is NaN and has no face",
     [](S& s, E& e) {
       e.error = "(vertex " + s.number_of_points() + "): the coordinate \"nan\" is not finite";
       return obj_text(s) + "v nan nan nan\n";
     }},
    // ---- PLY, text
    {"ply", "ushort",
     [](S& s, E&) {
       return ply_text(s, {"ascii", "float", "uchar", "ushort", "", "vertex_indices"});
     }},
    {"ply", "header in capitals",
     [](S& s, E&) { return replaced(replaced(ply_text(s, {}), "element", "ELEMENT"), "ply\n", "PLY \n"); }},
    {"ply", "comments before the format, blank lines",
     [](S& s, E&) {
       return replaced(replaced(ply_text(s, {}), "ply\n", "ply\ncomment x\n\n"), "end_header\n", "\nend_header\n\n");
     }},
    {"ply", "a byte order mark and CR LF",
     [](S& s, E&) { return "\xef\xbb\xbf" + replaced(ply_text(s, {}), "\n", "\r\n"); }},
    {"ply", "CR alone", [](S& s, E&) { return replaced(ply_text(s, {}), "\n", "\r"); }},
    {"ply", "rows over several lines",
     [](S& s, E&) {
       return with_line(ply_text(s, {}), s.ply_face(s.middle()),
                        [](const std::string& l) { return replaced(l, " ", "\n"); });
     }},
    {"ply", "one row too long",
     [](S& s, E& e) {
       e.error = ply_at(s.ply_face(s.middle()), "face", s.middle()) + ": \"0\" is behind the numbers";
       return appended(ply_text(s, {}), s.ply_face(s.middle()), " 0");
     }},
    {"ply", "all rows too long",
     [](S& s, E& e) {
       e.error =
         ply_at(s.ply_face(0) + 1, "face", 0) + ": \"7\" is behind the numbers that the header names (vertex_indices)";
       return replaced(ply_text(s, {"ascii", "float", "uchar", "int", "uchar", "vertex_indices"}),
                       "property uchar extra\nend", "end");
     }},
    {"ply", "one row too short",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.ply_face(s.middle())) + ", element face " + std::to_string(s.middle()) +
                 ", which goes on over line";
       return with_line(ply_text(s, {}), s.ply_face(s.middle()), "3 0 1");
     }},
    {"ply", "a vertex missing",
     [](S& s, E& e) {
       e.error = ply_at(s.ply_face(0) - 1, "vertex", s.v() - 1) + ": ";
       return without_line(ply_text(s, {}), s.ply_vertex(1));
     }},
    {"ply", "a face missing",
     [](S& s, E& e) {
       e.error =
         "the file ends too early, after " + s.number_of_points() + " vertices and " + std::to_string(s.f() - 1);
       return without_line(ply_text(s, {}), s.ply_face(s.middle()));
     }},
    {"ply", "a face doubled",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.ply_face(s.f())) + ": \"3\" is behind the";
       return doubled(ply_text(s, {}), s.ply_face(s.middle()));
     }},
    {"ply", "fewer vertices announced",
     [](S& s, E& e) {
       e.error = ply_at(s.ply_vertex(s.v() - 1), "face", 0) + ": ";
       return ply_with_count(ply_text(s, {}), "vertex", s.v(), s.v() - 1);
     }},
    {"ply", "more vertices announced",
     [](S& s, E& e) {
       e.error = ply_at(s.ply_face(0), "vertex", s.v()) + ": ";
       return ply_with_count(ply_text(s, {}), "vertex", s.v(), s.v() + 1);
     }},
    {"ply", "a property of unknown type",
     [](S& s, E& e) {
       e.error = "line 7 of the header: \"property flot y\" has a type that is not known";
       return replaced(ply_text(s, {}), "float y", "flot y");
     }},
    {"ply", "a property twice",
     [](S& s, E& e) {
       e.error = "line 8 of the header: \"property float y\" names a property for the second time";
       return replaced(ply_text(s, {}), "float z", "float y");
     }},
    {"ply", "an element twice",
     [](S& s, E& e) {
       e.error = "names an element for the second time";
       return doubled(ply_text(s, {}), 9);
     }},
    {"ply", "end_headr",
     [](S& s, E& e) {
       e.error = "line 11 of the header: \"end_headr\" is not understood";
       return replaced(ply_text(s, {}), "end_header", "end_headr");
     }},
    {"ply", "numbers of any kind in properties that are skipped",
     [](S& s, E&) {
       std::string text = ply_text(s, {"ascii", "float", "uchar", "int", "uchar", "vertex_indices"});
       for (const auto& [place, number] : {std::pair{s.ply_vertex(0), "nan"},
                                           {s.ply_vertex(1), "-inf"},
                                           {s.ply_face(0), "300.5"},
                                           {s.ply_face(1), "1e999"}})
         text = with_line(text, place + 2,
                          [number = number](const std::string& l) { return l.substr(0, l.rfind(' ') + 1) + number; });
       return text;
     }},
    {"ply", "a word in a property that is skipped",
     [](S& s, E& e) {
       e.error = ply_at(s.ply_face(1) + 2, "face", 1) + ": \"none\" is not a number, which is needed for extra";
       return with_line(ply_text(s, {"ascii", "float", "uchar", "int", "uchar", "vertex_indices"}), s.ply_face(1) + 2,
                        [](const std::string& l) { return l.substr(0, l.rfind(' ')) + " none"; });
     }},
    {"ply", "binary, coordinates that are integers",
     [](S& s, E&) {
       return ply_text(s, {"binary_big_endian", "short"});
     }},
    {"ply", "binary, coordinates that are integers without a sign",
     [](S& s, E&) {
       return ply_text(s, {"binary_little_endian", "uint"});
     }},
    {"ply", "strips", [](S& s, E&) { return strips(s, "ascii", "int"); }},
    {"ply", "a strip of two",
     [](S& s, E& e) {
       e.error = "element tristrips 0: a strip of triangles ends after 2 vertices";
       return strips(s, "ascii", "int", " 0 1 -1");
     }},
    {"ply", "faces before vertices, lists in vertices, other elements",
     [](S& s, E&) {
       std::string t = ply_text(s, {});
       const std::size_t end = t.find("end_header\n") + 11, faces = begin_of_line(t, s.ply_face(0));
       return "ply\nformat ascii 1.0\nelement other 2\nproperty list uchar float a\nproperty int b\nelement face " +
              s.number_of_faces() + "\nproperty list uchar int vertex_index\nelement vertex " + s.number_of_points() +
              "\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar int more\nend_header\n2 1 2 "
              "3\n0 4\n" +
              t.substr(faces) + replaced(t.substr(end, faces - end), "\n", " 2 8 9\n");
     }},
    {"ply", "faces by another name",
     [](S& s, E& e) {
       e.warning = "the header announces 1 element \"polygon\" with lists of vertices: left out";
       return replaced(ply_text(s, {}), "end_header",
                       "element polygon 1\nproperty list uchar int vertex_index\nend_header") +
              "3 0 1 2\n";
     }},
    {"ply", "corners twice",
     [](S& s, E& e) {
       e.warning = "the elements face have corners twice: vertex_indices are read, and vertex_index left out";
       const std::string t = ply_text(s, {"ascii", "float", "uchar", "int", "", "vertex_indices"});
       const std::size_t faces = begin_of_line(t, s.ply_face(0));
       return replaced(t.substr(0, faces), "end_header", "property list uchar int vertex_index\nend_header") +
              replaced(t.substr(faces), "\n", " 3 0 0 0\n");
     }},
    // ---- PLY, binary
    {"ply", "big endian, ushort",
     [](S& s, E&) {
       return ply_text(s, {"binary_big_endian", "float", "uchar", "ushort", "", "vertex_indices"});
     }},
    {"ply", "little endian, int and short",
     [](S& s, E&) {
       return ply_text(s, {"binary_little_endian", "double", "int", "short", "uchar", "vertex_index"});
     }},
    {"ply", "long integers",
     [](S& s, E&) {
       return ply_text(s, {"binary_little_endian", "double", "int64", "uint64", "int64", "vertex_indices"});
     }},
    {"ply", "a long integer that is no vertex, though its lower half is one",
     [](S& s, E& e) {
       e.error = "element face 0: the list vertex_indices has 4294967296.000000 where an integer is needed";
       std::string text = ply_text(s, {"binary_little_endian", "double", "uchar", "int64"});
       text[text.find("end_header\n") + 11 + 24 * s.points.size() + 1 + 4] = 1;
       return text;
     }},
    {"ply", "binary, fewer faces announced",
     [](S& s, E& e) {
       e.error = "on there are 13 bytes behind the elements that the header announces (" + s.number_of_points() +
                 " vertex, " + std::to_string(s.f() - 1) + " face)";
       return ply_with_count(ply_text(s, {"binary_little_endian"}), "face", s.f(), s.f() - 1);
     }},
    {"ply", "binary, more faces announced",
     [](S& s, E& e) {
       e.error = "element face " + s.number_of_faces() + ": the file ends within vertex_indices";
       return ply_with_count(ply_text(s, {"binary_little_endian"}), "face", s.f(), s.f() + 1);
     }},
    {"ply", "binary, more vertices announced",
     [](S& s, E& e) {
       e.error = "element face 0: the list of its vertices is empty, and no face names the last vertex, " +
                 s.number_of_points() + ": remove the face, or correct the header";
       return ply_with_count(ply_text(s, {"binary_little_endian"}), "vertex", s.v(), s.v() + 1);
     }},
    {"ply", "binary, fewer vertices announced",
     [](S& s, E& e) {
       e.error = "is empty: the file may be damaged before it";
       return ply_with_count(ply_text(s, {"binary_big_endian", "short"}), "vertex", s.v(), s.v() - 1);
     }},
    {"ply", "binary, more vertices announced, two of the faces taken for them",
     [](S& s, E& e) {
       e.error = "element face 0: the list of its vertices is empty, and no face names the last vertex";
       return ply_with_count(ply_text(s, {"binary_little_endian", "double"}), "vertex", s.v(), s.v() + 1);
     }},
    {"ply", "binary, an empty face at first",
     [](S& s, E& e) {
       e.faces = s.f() + 1;
       return with_empty_face(s, ply_text(s, {"binary_big_endian"}));
     }},
    {"ply", "binary, an empty face at first, before the vertices",
     [](S& s, E& e) {
       e.faces = s.f() + 1;
       const std::string t = with_empty_face(s, ply_text(s, {"binary_little_endian"}));
       const std::size_t vertices = t.find("element vertex"), faces = t.find("element face"),
                         end = t.find("end_header\n"), body = end + 11;
       return t.substr(0, vertices) + t.substr(faces, end - faces) + t.substr(vertices, faces - vertices) +
              "end_header\n" + t.substr(body + 12 * s.v()) + t.substr(body, 12 * s.v());
     }},
    {"ply", "binary, an empty face at first, behind other elements",
     [](S& s, E& e) {
       e.error = "element face 0: the list of its vertices is empty: remove the face, or correct the header";
       const std::string t = with_empty_face(s, ply_text(s, {"binary_little_endian"}));
       const std::size_t at = t.find("end_header\n") + 11 + 12 * s.v();
       return replaced(t.substr(0, at), "element face", "element edge 1\nproperty uchar a\nelement face") + "a" +
              t.substr(at);
     }},
    {"ply", "binary, an empty face at first, the last vertex without faces",
     [](S& s, E& e) {
       e.error = "no face names the last vertex, " + s.number_of_points();
       std::string t = with_empty_face(s, ply_text(s, {"binary_big_endian"}));
       t.insert(t.find("end_header\n") + 11 + 12 * s.v(), 12, '\1');
       return ply_with_count(t, "vertex", s.v(), s.v() + 1);
     }},
    {"ply", "binary, a byte missing",
     [](S& s, E& e) {
       e.error = "; the first face that names a vertex that is not there is face " + std::to_string(s.middle());
       std::string t = ply_text(s, {"binary_little_endian"});
       return t.erase(t.size() - 13 * (s.f() - s.middle()) + 8, 1);
     }},
    {"ply", "binary, a vertex that is NaN and has no face",
     [](S& s, E& e) {
       std::string t = ply_text(s, {"binary_little_endian"});
       const std::size_t faces = t.find("end_header\n") + 11 + 12 * s.v();
       e.error = "element vertex " + s.number_of_points() + ": a coordinate is not finite (the element begins at byte ";
       t.insert(faces, std::string("\0\0\0\0\0\0\xc0\x7f\0\0\0\0", 12));
       return ply_with_count(t, "vertex", s.v(), s.v() + 1);
     }},
    {"ply", "binary, a vertex that is infinite, with a property that is a list",
     [](S& s, E& e) {
       std::string t = ply_text(s, {"binary_big_endian"});
       const std::size_t faces = t.find("end_header\n") + 11 + 12 * s.v();
       std::string vertices;
       for (std::size_t v = 0; v < s.v(); ++v)
         vertices += t.substr(faces - 12 * (s.v() - v), 12) + std::string(1, '\0');
       vertices.replace(13, 4, "\xff\x80\0\0", 4);
       e.error = "element vertex 1: a coordinate is not finite";
       t.replace(faces - 12 * s.v(), 12 * s.v(), vertices);
       return replaced(t, "element face", "property list uchar int more\nelement face");
     }},
    {"ply", "binary, cut off",
     [](S& s, E& e) {
       e.error = "element face " + std::to_string(s.f() - 1) + ": the file ends within vertex_indices";
       std::string t = ply_text(s, {"binary_big_endian"});
       t.pop_back();
       return t;
     }},
    {"ply", "binary, a line end behind it",
     [](S& s, E& e) {
       e.warning = "on there is 1 byte behind the elements";
       return ply_text(s, {"binary_little_endian"}) + "\n";
     }},
    {"ply", "binary strips", [](S& s, E&) { return strips(s, "binary_big_endian", "int"); }},
    // ---- TS
    {"ts", "small letters", [](S& s, E&) { return replaced(replaced(ts_text(s), "TRGL", "trgl"), "VRTX", "Vrtx"); }},
    {"ts", "properties of triangles",
     [](S& s, E&) { return ts_text(s, "TRGL_PROPERTIES a b\nTRGL_ESIZES 1 2\n", "VRTX ", "", " 1 2 3"); }},
    {"ts", "properties that are not announced",
     [](S& s, E& e) {
       e.error = at(s.ts_face(0), "face", 0) + ": there is more in the line than three vertices";
       return ts_text(s, "", "VRTX ", "", " 1");
     }},
    {"ts", "a property missing",
     [](S& s, E& e) {
       e.error = at(s.ts_face(0) + 1, "face", 0) + ": three vertices are not followed by 2 properties";
       return ts_text(s, "TRGL_PROPERTIES a b\n", "VRTX ", "", " 1");
     }},
    {"ts", "PVRTX, control nodes",
     [](S& s, E&) {
       return ts_text(s, "PROPERTIES a\nPROPERTY_CLASS_HEADER a {\n*x: VRTX\n}\n", "PVRTX ", " -99999 CNXYZ");
     }},
    {"ts", "several TFACE, ATOM",
     [](S& s, E&) {
       return with_line(ts_text(s), s.ts_face(s.middle()),
                        [](const std::string& l) { return "TFACE\nATOM 1000000 1\n" + l; });
     }},
    {"ts", "another object before it",
     [](S& s, E& e) {
       e.warning = "line 1: the part of the kind \"PLine\" is not a surface";
       return "GOCAD PLine 1\nILINE\nVRTX 1 0 0 0\nVRTX 2 1 1 1\nSEG 1 2\nEND\n" + ts_text(s);
     }},
    {"ts", "two parts",
     [](S& s, E& e) {
       e.faces = 2 * s.f();
       return ts_text(s) + ts_text(s);
     }},
    {"ts", "TRG",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.ts_face(s.middle())) + ", \"TRG\": it is not understood";
       return with_line(ts_text(s), s.ts_face(s.middle()), "TRG 1 2 3");
     }},
    {"ts", "TRG before all else",
     [](S& s, E& e) {
       e.error = "line 5, \"TRG\": it is not understood";
       return replaced(ts_text(s), "TFACE\n", "TRG 1 2 3\n");
     }},
    {"ts", "VRTXX",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.ts_vertex(1)) + ", \"VRTXX\": it is not understood";
       return with_line(ts_text(s), s.ts_vertex(1), "VRTXX 2 0 0 0");
     }},
    {"ts", "a vertex missing",
     [](S& s, E& e) {
       e.error = "the face names vertex 1, but its part has no vertex of this number";
       return without_line(ts_text(s), s.ts_vertex(0));
     }},
    {"ts", "TRGL behind another word",
     [](S& s, E& e) {
       e.error = "line " + std::to_string(s.ts_face(0)) + ", \"TRGL\": it is not at the beginning of a line";
       return with_line(ts_text(s), s.ts_face(0), "TFACE TRGL 1 2 3");
     }},
    {"ts", "a name with TRGL",
     [](S& s, E&) { return replaced(ts_text(s), "HEADER {", "HEADER {\nname: Fault TRGL 2"); }},
    {"ts", "no TFACE", [](S& s, E&) { return replaced(ts_text(s), "TFACE\n", ""); }},
    {"ts", "an open brace",
     [](S& s, E& e) {
       e.error = "line 4, \"TFACE\": the brace on line 2 is not closed before it";
       return without_line(ts_text(s), 4);
     }},
    {"ts", "no END",
     [](S& s, E& e) {
       e.error = "the file has no line END";
       return replaced(ts_text(s), "END\n", "");
     }},
    {"ts", "END in the middle",
     [](S& s, E& e) {
       e.error =
         "line " + std::to_string(s.ts_face(s.middle()) + 1) + ", \"TRGL\": nothing but a line GOCAD may follow";
       return with_line(ts_text(s), s.ts_face(s.middle()), [](const std::string& l) { return "END\n" + l; });
     }},
    {"ts", "a comment with CR and a vertex",
     [](S& s, E& e) {
       e.error = at_line_with_cr(s.ts_face(0));
       return appended(ts_text(s), s.ts_face(0), " # a\rPVRTX 99 1 2 3 CNXYZ");
     }},
    {"ts", "CR alone", [](S& s, E&) { return replaced(ts_text(s), "\n", "\r"); }}};
}

class Unusual_files : public Surface_file_test
{};

TEST_F(Unusual_files, are_read_or_refused_at_the_place)
{
  std::size_t files = 0;
  // No more vertices than a short integer can count.
  const bool is_night = std::getenv("IDT_FILE_MUTATIONS") != nullptr;
  for (const std::uint32_t n : {2u, is_night ? 180u : 50u}) {
    const Sheet_in_files sheet(n);
    for (const Case& row : cases()) {
      Expected expected;
      const std::string content = row.make(sheet, expected), file = write(std::string("a.") + row.extension, content);
      SCOPED_TRACE(std::string(row.extension) + ", " + row.what + ", " + std::to_string(sheet.f()) + " faces");
      std::string outcome;
      try {
        const IT::Polygon_soup soup = IT::read_polygon_soup(file);
        EXPECT_EQ(expected.error, "") << "it was read";
        EXPECT_EQ(soup.number_of_faces(), expected.faces == 0 ? sheet.f() : expected.faces);
        EXPECT_EQ(soup.warnings.size(), expected.warning.empty() ? 0u : 1u);
        for (const std::string& warning : soup.warnings)
          EXPECT_TRUE(contains(warning, expected.warning)) << warning;
        EXPECT_EQ(faces_of_file::difference(row.extension, content, soup), "");
        outcome =
          std::to_string(soup.number_of_faces()) + " faces" + (soup.warnings.empty() ? "" : "; " + soup.warnings[0]);
      } catch (const IT::Invalid_surface_error& error) {
        EXPECT_FALSE(expected.error.empty()) << error.what();
        EXPECT_TRUE(contains(error.what(), expected.error))
          << error.what() << "\nwhere this is expected: " << expected.error;
        outcome = std::string(error.what()).substr(file.size() + 2);
      }
      if (std::getenv("IDT_SHOW_FILES") != nullptr)
        std::cout << "| " << row.extension << " | " << row.what << " | " << sheet.f() << " | " << outcome << " |"
                  << std::endl;
      ++files;
    }
  }
  EXPECT_GE(files, 150u);
}

} // namespace
