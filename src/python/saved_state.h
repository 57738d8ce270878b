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

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>

#include <cstddef>
#include <memory>
#include <string>

namespace idt_python {

const auto while_no_signal = CGAL::parameters::visitor([] { return Signal_watch::goes_on(); });

// The output of write(stream), which runs without Python's lock, with room for the given numbers of faces of the input
// and of the triangulation.
template <class Write>
py::bytes written_bytes(std::size_t number_of_faces, const Write& write)
{
  std::string bytes;
  bytes.reserve(60 * number_of_faces);
  boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> os(bytes);
  write(os);
  os.flush();
  return py::bytes(bytes);
}

inline std::unique_ptr<Surface> surface_of_bytes(const py::bytes& bytes)
{
  char* data = nullptr;
  py::ssize_t size = 0;
  if (PyBytes_AsStringAndSize(bytes.ptr(), &data, &size) != 0)
    throw py::error_already_set();
  return without_lock([&] {
    boost::iostreams::stream<boost::iostreams::array_source> is(data, std::size_t(size));
    return std::make_unique<Surface>(IT::read_triangulation<CGAL::Parallel_if_available_tag>(is, while_no_signal),
                                     true);
  });
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SAVED_STATE_H
