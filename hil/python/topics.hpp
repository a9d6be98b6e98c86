#pragma once

#include <pybind11/pybind11.h>

namespace drydock::python {

/// Each puts the functions of one topic into the module.
void add_captures(pybind11::module_& module);
void add_recordings(pybind11::module_& module);
void add_truth(pybind11::module_& module);
void add_lockstep(pybind11::module_& module);
void add_studies(pybind11::module_& module);
void add_calibrations(pybind11::module_& module);

}  // namespace drydock::python
