#include "hil/python/measurement_object.hpp"

#include <fmt/format.h>

#include "drivers/text/measurement_fields.hpp"
#include "hil/python/values.hpp"

namespace drydock::python {
namespace {

std::string_view type_name(const MeasurementObject& object) {
  return std::visit([](const auto& m) { return type_of(m); }, object.measurement);
}

std::string device_name(const MeasurementObject& object) {
  return object.devices->at(origin_of(object.measurement).device);
}

/// The fields are attributes; only the one that is asked for becomes a Python value.
py::object attribute(const MeasurementObject& object, const std::string& name) {
  py::object found;
  std::string known;
  std::visit(
      [&](const auto& m) {
        visit_fields(m, [&](std::string_view field, const auto& value) {
          if (field == name) found = value_of(value);
        });
      },
      object.measurement);
  if (found) return found;
  std::visit(
      [&](const auto& m) {
        visit_fields(m, [&](std::string_view field, const auto&) {
          known.append(known.empty() ? "" : ", ").append(field);
        });
      },
      object.measurement);
  throw py::attribute_error(fmt::format("{} has no {}, but: {}", type_name(object), name, known));
}

py::dict fields(const MeasurementObject& object) {
  return std::visit([](const auto& m) { return dict_of(m); }, object.measurement);
}

}  // namespace

void add_measurement_object(py::module_& module) {
  py::class_<MeasurementObject>(module, "Measurement")
      .def_property_readonly("device", &device_name)
      .def_property_readonly("type", &type_name)
      .def_property_readonly("valid_at_ns",
                             [](const MeasurementObject& o) {
                               return origin_of(o.measurement).valid_at.time_since_epoch().count();
                             })
      .def_property_readonly(
          "received_at_ns",
          [](const MeasurementObject& o) {
            return origin_of(o.measurement).received_at.time_since_epoch().count();
          })
      .def("fields", &fields)
      .def("__getattr__", &attribute)
      .def("__repr__", [](const MeasurementObject& o) {
        return fmt::format("<{} of {} at {} ns>", type_name(o), device_name(o),
                           origin_of(o.measurement).valid_at.time_since_epoch().count());
      });
}

}  // namespace drydock::python
