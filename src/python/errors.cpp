// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exceptions of the library as those of the Python package: the classes are defined in Python, where their
// documentation is.

#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <exception>
#include <string>

namespace idt_python {

namespace py = pybind11;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

const char* name_of(IT::Invalid_surface_error::Defect defect)
{
  using Defect = IT::Invalid_surface_error::Defect;
  switch (defect) {
  case Defect::EMPTY:
    return "EMPTY";
  case Defect::BAD_INDEX:
    return "BAD_INDEX";
  case Defect::NOT_A_TRIANGLE:
    return "NOT_A_TRIANGLE";
  case Defect::REPEATED_CORNER:
    return "REPEATED_CORNER";
  case Defect::DUPLICATE_FACE:
    return "DUPLICATE_FACE";
  case Defect::NON_MANIFOLD_EDGE:
    return "NON_MANIFOLD_EDGE";
  case Defect::INCONSISTENT_ORIENTATION:
    return "INCONSISTENT_ORIENTATION";
  case Defect::NON_MANIFOLD_VERTEX:
    return "NON_MANIFOLD_VERTEX";
  case Defect::INVALID_GLUING:
    return "INVALID_GLUING";
  case Defect::NOT_FINITE:
    return "NOT_FINITE";
  case Defect::OUT_OF_RANGE:
    return "OUT_OF_RANGE";
  case Defect::ZERO_LENGTH_EDGE:
    return "ZERO_LENGTH_EDGE";
  case Defect::TRIANGLE_INEQUALITY:
    return "TRIANGLE_INEQUALITY";
  case Defect::DEGENERATE_FACE:
    return "DEGENERATE_FACE";
  case Defect::UNREFERENCED_VERTEX:
    return "UNREFERENCED_VERTEX";
  case Defect::SEVERAL_COMPONENTS:
    return "SEVERAL_COMPONENTS";
  case Defect::WRONG_TOPOLOGY:
    return "WRONG_TOPOLOGY";
  case Defect::UNREADABLE:
    return "UNREADABLE";
  }
  return "";
}

py::object class_of(const char* name) { return py::module_::import("intrinsic_triangulations._errors").attr(name); }

// The function of this package that can fix it.
const char* advice(IT::Invalid_surface_error::Defect defect)
{
  using Defect = IT::Invalid_surface_error::Defect;
  switch (defect) {
  case Defect::INCONSISTENT_ORIENTATION:
    return " (orient(V, F) does it, or repair(V, F), which cuts where that is impossible)";
  case Defect::NOT_A_TRIANGLE:
  case Defect::REPEATED_CORNER:
  case Defect::DUPLICATE_FACE:
  case Defect::NON_MANIFOLD_EDGE:
  case Defect::NON_MANIFOLD_VERTEX:
  case Defect::ZERO_LENGTH_EDGE:
    return "; repair(V, F) makes a surface of it";
  default:
    return "";
  }
}

void raise(const char* name, const IT::Error& error) { PyErr_SetString(class_of(name).ptr(), error.what()); }

void translate(std::exception_ptr exception)
{
  if (!exception)
    return;
  try {
    std::rethrow_exception(exception);
  } catch (const IT::Invalid_surface_error& error) {
    const py::object cls = class_of("InvalidSurfaceError");
    std::string text = error.what();
    const std::string in_cpp = ", as repair_polygons() does";
    if (const std::size_t at = text.find(in_cpp); at != std::string::npos)
      text.erase(at, in_cpp.size());
    PyErr_SetObject(cls.ptr(),
                    cls(text + advice(error.defect()), name_of(error.defect()), error.element(), error.count()).ptr());
  } catch (const IT::Invalid_argument_error& error) {
    raise("InvalidArgumentError", error);
  } catch (const IT::Invalid_point_error& error) {
    raise("InvalidPointError", error);
  } catch (const IT::Undecided_error& error) {
    raise("UndecidedError", error);
  } catch (const IT::Integer_overflow_error& error) {
    raise("IntegerOverflowError", error);
  } catch (const IT::Numerical_error& error) {
    raise("NumericalError", error);
  } catch (const IT::Cancelled_error& error) {
    raise("CancelledError", error);
  } catch (const IT::Error& error) {
    raise("Error", error);
  }
}

} // namespace

void register_errors() { py::register_local_exception_translator(&translate); }

} // namespace idt_python
