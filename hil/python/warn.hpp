#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace drydock::python {

/// A RuntimeWarning of Python at the line that called the package; an empty line is none.
inline void warn(const std::string& line) {
  if (!line.empty() && PyErr_WarnEx(PyExc_RuntimeWarning, line.c_str(), 2) != 0)
    throw pybind11::error_already_set();
}

}  // namespace drydock::python
