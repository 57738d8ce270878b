// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Triangulations as bytes that another process reads.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SAVED_STATE_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SAVED_STATE_H

#include "python/Surface.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/triangulation_io.h>

#include <CGAL/tags.h>

#include <istream>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>

namespace idt_python {

// Reads bytes where they are.
class Bytes_in_place : public std::streambuf
{
public:
  // \param bytes which have to live as long
  explicit Bytes_in_place(const py::bytes& bytes)
  {
    char* data = nullptr;
    py::ssize_t size = 0;
    if (PyBytes_AsStringAndSize(bytes.ptr(), &data, &size) != 0)
      throw py::error_already_set();
    setg(data, data, data + size);
  }
};

// Appends bytes to a text, which a stream of strings would copy in the end.
class Bytes_to_text : public std::streambuf
{
public:
  std::string text;

private:
  std::streamsize xsputn(const char* s, std::streamsize n) override
  {
    text.append(s, std::size_t(n));
    return n;
  }
  int_type overflow(int_type c) override
  {
    text.push_back(traits_type::to_char_type(c));
    return c;
  }
};

const auto while_no_signal = CGAL::parameters::visitor([] { return Signal_watch::goes_on(); });

// What write(stream) writes without Python's lock.
template <class Write>
py::bytes written_bytes(const Write& write)
{
  Bytes_to_text bytes;
  std::ostream os(&bytes);
  write(os);
  return py::bytes(bytes.text);
}

inline std::unique_ptr<Surface> surface_of_bytes(const py::bytes& bytes)
{
  Bytes_in_place buffer(bytes);
  return without_lock([&] {
    std::istream is(&buffer);
    return std::make_unique<Surface>(IT::read_triangulation<CGAL::Parallel_if_available_tag>(is, while_no_signal),
                                     true);
  });
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SAVED_STATE_H
