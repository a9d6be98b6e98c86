#include "hil/calibrate/outcome.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"
#include "hil/python/values.hpp"
#include "hil/track/gather.hpp"

namespace drydock::python {
namespace {

py::object calibrate(const std::string& recording, const std::string& rig) {
  std::string json;
  {
    const OutsidePython others_run;
    json = to_json(calibrate::calibrated(track::gather_recording(recording, {}, rig)));
  }
  return value_of_json(json);
}

}  // namespace

void add_calibrations(py::module_& module) {
  using py::arg;
  module.def("calibrate", &calibrate, arg("recording"), py::kw_only(), arg("rig"));
}

}  // namespace drydock::python
