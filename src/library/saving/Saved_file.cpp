// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers

#include <CGAL/Intrinsic_triangulations/internal/saving/Saved_file.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include "Byte_stream.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include "../engine/history/Crossing_sequence.h"
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <istream>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The contents of a file's header. Its text is determined by these numbers, so a header is right if it equals that
// text.
struct Saved_header
{
  Metric_kind metric = Metric_kind::POINTS;
  Tie_proof tie_proof = Tie_proof::PROBABLE_IF_COSTLY;
  bool has_constraints = false;
  std::size_t vertices = 0, edges = 0, faces = 0; // of the input
  std::size_t inserted_vertices = 0, intrinsic_vertices = 0, intrinsic_edges = 0, intrinsic_faces = 0;

  static constexpr std::size_t number_of_counts = number_of_stages + 1; // the last one counts ties

  std::string text() const
  {
    std::ostringstream os;
    os.imbue(std::locale::classic());
    const auto element = [&](const char* name, std::size_t number, std::initializer_list<const char*> properties) {
      os << "element " << name << ' ' << number << '\n';
      for (const char* property : properties)
        os << "property " << property << '\n';
    };
    os << "ply\nformat binary_little_endian 1.0\n"
       << "comment intrinsic triangulation, version 1\n"
       << "comment traits Filtered_edge_length_traits\n"
       << "comment ties " << (tie_proof == Tie_proof::PROVEN ? "proven" : "probable") << '\n';
    if (metric == Metric_kind::POINTS) {
      element("vertex", vertices, {"double x", "double y", "double z", "uint halfedge"});
    } else {
      element("vertex", vertices, {"uint halfedge"});
    }
    element("face", faces, {"list uchar uint vertex_indices", "uint halfedge_0", "uint halfedge_1", "uint halfedge_2"});
    if (metric == Metric_kind::LENGTHS)
      element("input_edge", edges, {"double length"});
    else if (metric == Metric_kind::SQUARED_LENGTHS)
      element("input_edge", edges, {"list uint uchar squared_length"});
    else
      os << "comment input edges " << edges << '\n';
    element("intrinsic_vertex", intrinsic_vertices, {"uint halfedge"});
    element("inserted_vertex", inserted_vertices, {"uint halfedge", "double a", "double b", "double c"});
    element("intrinsic_face", intrinsic_faces,
            {"uint halfedge_0", "uint halfedge_1", "uint halfedge_2", "double four_areas", "double error",
             "uchar is_straight"});
    element("intrinsic_edge", intrinsic_edges,
            {"double squared_length", "int crossings", "uint input_halfedge_0", "uint input_halfedge_1"});
    if (has_constraints)
      os << "property uchar is_constrained\n";
    element("count", number_of_counts, {"uint low", "uint high"});
    os << "end_header\n";
    return os.str();
  }

  // \exception Invalid_surface_error
  static Saved_header read(Byte_reader& bytes)
  {
    constexpr std::size_t largest_number_of_lines = 40;
    Saved_header result;
    std::vector<std::string> lines;
    do {
      lines.push_back(bytes.line());
      result.note(lines.back());
    } while (lines.back() != "end_header" && lines.size() < largest_number_of_lines && lines[0] == "ply");
    std::istringstream expected(result.text());
    std::string line;
    for (std::size_t i = 0; std::getline(expected, line); ++i)
      if (i >= lines.size() || lines[i] != line)
        bytes.fail(0, "line " + std::to_string(i + 1) + " of the header is not \"" + line +
                        "\": this is no intrinsic triangulation, or was written by another version");
    return result;
  }

private:
  // Reads the parts that vary.
  void note(const std::string& line)
  {
    const auto number = [&](const char* before, std::size_t& n) {
      const std::string begin = before;
      std::uint32_t x = 0;
      if (line.compare(0, begin.size(), begin) == 0 && line.size() < begin.size() + 11) {
        for (std::size_t i = begin.size(); i < line.size(); ++i)
          if (line[i] < '0' || line[i] > '9')
            return;
        std::istringstream(line.substr(begin.size())) >> x;
        n = x;
      }
    };
    number("element vertex ", vertices);
    number("element face ", faces);
    number("element input_edge ", edges);
    number("comment input edges ", edges);
    number("element intrinsic_vertex ", intrinsic_vertices);
    number("element inserted_vertex ", inserted_vertices);
    number("element intrinsic_face ", intrinsic_faces);
    number("element intrinsic_edge ", intrinsic_edges);
    if (line == "property double length")
      metric = Metric_kind::LENGTHS;
    if (line == "property list uint uchar squared_length")
      metric = Metric_kind::SQUARED_LENGTHS;
    if (line == "comment ties proven")
      tie_proof = Tie_proof::PROVEN;
    if (line == "property uchar is_constrained")
      has_constraints = true;
  }
};

// In the unit of the input.
inline Rational unscaled_squared_length(const Input_metric& metric, const Delta_complex& input, Edge_index e)
{
  Rational s = squared_length(metric, input, e);
  const int k = 2 * metric.unit_exponent();
  if (k > 0)
    mpq_mul_2exp(s.backend().data(), s.backend().data(), mp_bitcnt_t(k));
  else if (k < 0)
    mpq_div_2exp(s.backend().data(), s.backend().data(), mp_bitcnt_t(-k));
  return s;
}

class Saved_file_writer
{
public:
  Saved_file_writer(std::ostream& os, const Exact_engine& engine, const Go_further& go_further)
    : bytes_(os), engine_(engine), correspondence_(engine.correspondence()), go_further_(go_further)
  {}

  void operator()(const Stage_counts& counts, const Stored_numbers& numbers, const std::vector<bool>& is_constrained)
  {
    const Delta_complex &input = correspondence_.input(), &complex = engine_.connectivity();
    check_crossings();
    bytes_.put(header(!is_constrained.empty()).text());
    put_vertices(input, true);
    for_each(input.faces(), [&](Face_index f) {
      const std::array<Halfedge_index, 3> h =
        sides(input, numbers.first_sides.empty() ? input.halfedge(f) : numbers.first_sides[f.idx()]);
      bytes_.put(std::uint8_t(3), input.source(h[0]).idx(), input.source(h[1]).idx(), input.source(h[2]).idx(),
                 h[0].idx(), h[1].idx(), h[2].idx());
    });
    put_lengths(engine_.metric());
    put_vertices(complex, false);
    mend(numbers);
    for (const Surface_point& p : correspondence_.locations())
      bytes_.put(p.halfedge.idx(), p.coordinates[0], p.coordinates[1], p.coordinates[2]);
    for_each(complex.faces(), [&](Face_index f) {
      const std::array<Halfedge_index, 3> h = sides(complex, complex.halfedge(f));
      const std::array<double, 2> area = mended_areas_.empty() ? numbers.area(f) : mended_areas_[f.idx()];
      bytes_.put(h[0].idx(), h[1].idx(), h[2].idx(), area[0], area[1],
                 std::uint8_t(Engine_numbers(engine_).is_known_to_be_straight(f)));
    });
    for_each(complex.edges(), [&](Edge_index e) {
      const Halfedge_index h = complex.halfedge(e);
      bytes_.put(mended_squared_lengths_.empty() ? numbers.squared_length(e) : mended_squared_lengths_[e.idx()],
                 std::int32_t(correspondence_.coordinates().crossings(e)), correspondence_.input_halfedge(h).idx(),
                 correspondence_.input_halfedge(complex.opposite(h)).idx());
      if (!is_constrained.empty())
        bytes_.put(std::uint8_t(is_constrained[e.idx()]));
    });
    for (std::uint64_t n : counts.decided)
      bytes_.put(n);
    bytes_.put(counts.ties);
    bytes_.flush();
  }

private:
  // A copy is made only if something has to be corrected.
  void mend(const Stored_numbers& numbers)
  {
    if (!numbers.are_known)
      return;
    const Delta_complex& complex = engine_.connectivity();
    const std::vector<bool> are_bounded =
      bounded_faces(complex, numbers.squared_length, [&](Face_index f) { return numbers.area(f)[1]; });
    if (std::find(are_bounded.begin(), are_bounded.end(), false) == are_bounded.end())
      return;
    for (Edge_index e : complex.edges())
      mended_squared_lengths_.push_back(numbers.squared_length(e));
    for (Face_index f : complex.faces())
      mended_areas_.push_back(numbers.area(f));
    mend_unbounded(engine_, are_bounded, mended_squared_lengths_, mended_areas_);
  }

  Saved_header header(bool has_constraints) const
  {
    const Delta_complex &input = correspondence_.input(), &complex = engine_.connectivity();
    Saved_header result;
    result.metric = engine_.metric().rational_lengths()  ? Metric_kind::SQUARED_LENGTHS
                    : !engine_.metric().points().empty() ? Metric_kind::POINTS
                                                         : Metric_kind::LENGTHS;
    result.tie_proof = engine_.decisions().tie_proof;
    result.has_constraints = has_constraints;
    result.vertices = input.number_of_vertices();
    result.edges = input.number_of_edges();
    result.faces = input.number_of_faces();
    result.inserted_vertices = correspondence_.number_of_inserted_vertices();
    result.intrinsic_vertices = complex.number_of_vertices();
    result.intrinsic_edges = complex.number_of_edges();
    result.intrinsic_faces = complex.number_of_faces();
    return result;
  }

  void check_crossings() const
  {
    for (Edge_index e : engine_.connectivity().edges())
      if (const std::int64_t n = correspondence_.coordinates().crossings(e); n > Crossing_sequence::largest_number)
        throw Undecided_error("edge " + std::to_string(e.idx()) + " crosses " + std::to_string(n) +
                              " input edges, too many to be laid out: nobody could check that in a file");
  }

  template <class Range, class Put>
  void for_each(const Range& range, const Put& put)
  {
    std::size_t i = 0;
    for (auto x : range) {
      if ((++i & 0x3fff) == 0 && go_further_ && !go_further_())
        throw Cancelled_error("the writing of a triangulation was cancelled");
      put(x);
    }
  }

  static std::array<Halfedge_index, 3> sides(const Delta_complex& complex, Halfedge_index h)
  {
    return {h, complex.next(h), complex.prev(h)};
  }

  void put_vertices(const Delta_complex& complex, bool has_points)
  {
    const auto& points = engine_.metric().points();
    const int unit = engine_.metric().unit_exponent();
    for_each(complex.vertices(), [&](Vertex_index v) {
      if (has_points && !points.empty())
        for (double x : points[v.idx()])
          bytes_.put(std::ldexp(x, unit)); // which is exact
      bytes_.put(complex.halfedge(v).idx());
    });
  }

  void put_lengths(const Input_metric& metric)
  {
    for (double l : metric.lengths())
      bytes_.put(std::ldexp(l, metric.unit_exponent()));
    if (metric.rational_lengths())
      for (Edge_index e : correspondence_.input().edges()) {
        const std::string digits = unscaled_squared_length(metric, correspondence_.input(), e).str();
        bytes_.put(std::uint32_t(digits.size()));
        bytes_.put(digits);
      }
  }

  Byte_writer bytes_;
  const Exact_engine& engine_;
  const Correspondence& correspondence_;
  const Go_further& go_further_;
  Large_vector<double> mended_squared_lengths_;
  Large_vector<std::array<double, 2>> mended_areas_;
};

// The complex of untrusted halfedges, with their numbers: a halfedge without a face is on the border.
// \param faces the halfedges of each face in their order, first the one that the face names
// \param vertices for each vertex a halfedge that points to it, a border halfedge if there is one; null if it has no
//   face
// \exception Invalid_surface_error if they are not those of an oriented surface
// O(size)
inline Delta_complex complex_from_halfedges(std::size_t number_of_edges,
                                            const Large_vector<std::array<std::uint32_t, 3>>& faces,
                                            const Large_vector<std::uint32_t>& vertices)
{
  constexpr std::uint32_t none = Halfedge_index::null_index();
  Delta_complex::Halfedge_vector records(2 * number_of_edges, Delta_complex::Halfedge{none, none, none, none});
  Delta_complex::Descriptor_vector face_halfedges, vertex_halfedges;
  face_halfedges.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t h = faces[f][i];
      if (h >= records.size() || records[h].face != none)
        throw_not_a_triangulation("face", f,
                                  "names halfedge " + std::to_string(h) +
                                    (h < records.size() ? ", which another one has" : ", which does not exist"));
      records[h] = {faces[f][(i + 1) % 3], faces[f][(i + 2) % 3], none, f};
    }
    face_halfedges.push_back(Halfedge_index(faces[f][0]));
  }
  const auto is_border = [&](std::uint32_t h) { return records[h].face == none; };
  for (std::size_t h = 0; h < records.size(); h += 2)
    if (is_border(std::uint32_t(h)) && is_border(std::uint32_t(h + 1)))
      throw_not_a_triangulation("edge", h / 2, "has no face");

  // Around each vertex counterclockwise, and in the end along the border.
  vertex_halfedges.reserve(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const std::uint32_t first = vertices[v];
    vertex_halfedges.push_back(first == none ? Halfedge_index() : Halfedge_index(first));
    if (first == none)
      continue;
    if (first >= records.size())
      throw_not_a_triangulation("vertex", v, "names halfedge " + std::to_string(first) + ", which does not exist");
    std::uint32_t h = first;
    do {
      if (records[h].target != none)
        throw_not_a_triangulation(
          "vertex", v, "and vertex " + std::to_string(records[h].target) + " share halfedge " + std::to_string(h));
      records[h].target = v;
      const std::uint32_t from_v = h ^ 1;
      if (is_border(from_v)) {
        if (!is_border(first))
          throw_not_a_triangulation("vertex", v, "is on the border, and its halfedge is not");
        records[first].next = from_v;
        records[from_v].prev = first;
        break;
      }
      h = records[from_v].prev;
    } while (h != first);
  }
  for (std::size_t h = 0; h < records.size(); ++h)
    if (records[h].target == none || records[h].next == none || records[h].prev == none)
      throw_not_a_triangulation("halfedge", h, "points to no vertex");
  return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
}

class Saved_file_reader
{
public:
  Saved_file_reader(std::istream& is, const Go_further& go_further) : bytes_(is), go_further_(go_further) {}

  Saved_file operator()()
  {
    header_ = Saved_header::read(bytes_);
    check_numbers();
    Saved_file result;
    result.tie_proof = header_.tie_proof;
    result.metric_kind = header_.metric;

    Large_vector<std::uint32_t> vertices;
    const bool has_points = header_.metric == Metric_kind::POINTS;
    for_each(
      "vertex", header_.vertices, has_points ? 28 : 4,
      [&] {
        if (has_points) {
          const double x = bytes_.get<double>(), y = bytes_.get<double>();
          result.points.push_back({x, y, bytes_.get<double>()});
        }
        vertices.push_back(bytes_.get<std::uint32_t>());
      },
      vertices, result.points);
    Large_vector<std::array<std::uint32_t, 3>> corners, faces;
    for_each(
      "face", header_.faces, 25,
      [&] {
        if (bytes_.get<std::uint8_t>() != 3)
          bytes_.fail_here("the face is no triangle");
        corners.push_back(get_three());
        faces.push_back(get_three());
      },
      corners, faces);
    result.input = complex_from_halfedges(header_.edges, faces, vertices);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        if (result.input.source(Halfedge_index(faces[f][i])).idx() != corners[f][i])
          throw_not_a_triangulation("face", f, "has other vertices than its halfedges");
    if (header_.metric == Metric_kind::LENGTHS)
      for_each(
        "input_edge", header_.edges, 8, [&] { result.lengths.push_back(bytes_.get<double>()); }, result.lengths);
    if (header_.metric == Metric_kind::SQUARED_LENGTHS)
      result.metric = metric_from_squared_lengths();
    read_triangulation(result);
    for_each("count", Saved_header::number_of_counts, 8, [&, i = std::size_t(0)]() mutable {
      (i < number_of_stages ? result.counts.decided[i] : result.counts.ties) = bytes_.get<std::uint64_t>();
      ++i;
    });
    return result;
  }

private:
  void check_numbers() const
  {
    const Saved_header& h = header_;
    if (h.intrinsic_vertices != h.vertices + h.inserted_vertices)
      bytes_.fail(0, "the numbers of vertices do not fit together");
    if (h.edges > 3 * h.faces || h.intrinsic_edges > 3 * h.intrinsic_faces)
      bytes_.fail(0, "there are too many edges for the faces");
  }

  // \param filled the rows are appended to it
  template <class Take, class... Vector>
  void for_each(const char* element, std::size_t number, std::size_t size, Take take, Vector&... filled)
  {
    bytes_.begin(element, number, size);
    (filled.reserve(bytes_.rows_to_expect()), ...);
    for (std::size_t i = 0; i < number; ++i) {
      bytes_.next_row();
      if (bytes_.begins_block() && go_further_ && !go_further_())
        throw Cancelled_error("the reading of a triangulation was cancelled");
      take();
    }
  }
  std::array<std::uint32_t, 3> get_three()
  {
    const std::uint32_t a = bytes_.get<std::uint32_t>(), b = bytes_.get<std::uint32_t>();
    return {a, b, bytes_.get<std::uint32_t>()};
  }

  Input_metric metric_from_squared_lengths()
  {
    constexpr std::uint32_t most_digits = 1 << 20;
    std::vector<Rational> squared_lengths;
    for (std::size_t e = 0; e < header_.edges; ++e) {
      bytes_.begin("input_edge", 1, 4);
      bytes_.next_row();
      const std::uint32_t size = bytes_.get<std::uint32_t>();
      if (size > most_digits)
        throw_not_a_triangulation("input edge", e, "has a squared length of too many digits");
      squared_lengths.push_back(rational(bytes_.text(size), e));
    }
    return Intrinsic_triangulations::metric_from_squared_lengths(std::move(squared_lengths));
  }
  // Digits, perhaps a slash and more digits.
  static Rational rational(const std::string& text, std::size_t edge)
  {
    const std::size_t slash = (std::min)(text.find('/'), text.size());
    bool is_good = slash > 0 && slash + 1 != text.size();
    for (std::size_t i = 0; i < text.size(); ++i)
      is_good = is_good && (i == slash || (text[i] >= '0' && text[i] <= '9'));
    is_good = is_good && (slash == text.size() || text.find_first_not_of('0', slash + 1) != std::string::npos);
    if (!is_good)
      throw_not_a_triangulation("input edge", edge, "has a squared length that is no fraction");
    Rational result(text);
    mpq_canonicalize(result.backend().data()); // which "4/6" is not
    return result;
  }

  void read_triangulation(Saved_file& result)
  {
    Saved_triangulation& t = result.triangulation;
    Large_vector<std::uint32_t> vertices;
    for_each(
      "intrinsic_vertex", header_.intrinsic_vertices, 4, [&] { vertices.push_back(bytes_.get<std::uint32_t>()); },
      vertices);
    for_each("inserted_vertex", header_.inserted_vertices, 28, [&] {
      const Halfedge_index h = halfedge(bytes_.get<std::uint32_t>());
      const double a = bytes_.get<double>(), b = bytes_.get<double>();
      t.locations.push_back({h, {a, b, bytes_.get<double>()}});
    });
    Large_vector<std::array<std::uint32_t, 3>> faces;
    for_each(
      "intrinsic_face", header_.intrinsic_faces, 29,
      [&] {
        faces.push_back(get_three());
        const double area = bytes_.get<double>();
        t.areas.push_back({area, bytes_.get<double>()});
        t.is_straight.push_back(get_bool());
      },
      faces, t.areas, t.is_straight);
    t.connectivity = complex_from_halfedges(header_.intrinsic_edges, faces, vertices);
    t.coordinates = Normal_coordinates(t.connectivity);
    for_each(
      "intrinsic_edge", header_.intrinsic_edges, header_.has_constraints ? 21 : 20,
      [&, e = Edge_index(0)]() mutable {
        t.squared_lengths.push_back(bytes_.get<double>());
        const std::int32_t n = bytes_.get<std::int32_t>();
        if (n > Crossing_sequence::largest_number)
          bytes_.fail_here("the edge crosses more input edges than can be laid out");
        const Halfedge_index first = halfedge(bytes_.get<std::uint32_t>()),
                             second = halfedge(bytes_.get<std::uint32_t>());
        const Halfedge_index h = t.connectivity.halfedge(e);
        if (n != -1 || first != h || second != t.connectivity.opposite(h))
          t.coordinates.set(e, n, first, second);
        if (header_.has_constraints)
          result.is_constrained.push_back(get_bool());
        e = Edge_index(e.idx() + 1);
      },
      t.squared_lengths);
  }
  static Halfedge_index halfedge(std::uint32_t h)
  {
    return h == Halfedge_index::null_index() ? Halfedge_index() : Halfedge_index(h);
  }
  bool get_bool()
  {
    const std::uint8_t x = bytes_.get<std::uint8_t>();
    if (x > 1)
      bytes_.fail_here("a mark is neither 0 nor 1");
    return x == 1;
  }

  Byte_reader bytes_;
  const Go_further& go_further_;
  Saved_header header_;
};

void write_saved_file(std::ostream& os, const Exact_engine& engine, const Stage_counts& counts,
                      const Stored_numbers& numbers, const std::vector<bool>& is_constrained,
                      const Go_further& go_further)
{
  Saved_file_writer(os, engine, go_further)(counts, numbers, is_constrained);
}

Saved_file read_saved_file(std::istream& is, const Go_further& go_further)
{
  return Saved_file_reader(is, go_further)();
}

} // namespace CGAL::Intrinsic_triangulations::internal
