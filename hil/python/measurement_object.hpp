#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "hil/python/columns.hpp"

namespace drydock::python {

/// A measurement as a callback sees it. It stays valid after the callback.
struct MeasurementObject {
  std::shared_ptr<const std::vector<std::string>> devices;  ///< names
  measurement::Measurement measurement;
};

void add_measurement_object(py::module_& module);

}  // namespace drydock::python
