#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of drydock.";
  module.attr("__version__") = DRYDOCK_VERSION;
  drydock::python::add_ends(module);
  drydock::python::add_captures(module);
  drydock::python::add_recordings(module);
  drydock::python::add_truth(module);
  drydock::python::add_lockstep(module);
  drydock::python::add_studies(module);
  drydock::python::add_calibrations(module);
}
