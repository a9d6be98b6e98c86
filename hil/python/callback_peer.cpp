#include "hil/python/callback_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "estimators/external/estimate_reader.hpp"
#include "hil/python/measurement_object.hpp"
#include "hil/python/values.hpp"

namespace drydock::python {

StepObject CallbackPeer::object_of(const pipeline::Step& step) const {
  StepObject object{step.number, step.now.time_since_epoch().count(), py::list()};
  for (const auto& sample : step.samples)
    object.measurements.append(MeasurementObject{
        devices_, std::visit([](const auto& m) { return measurement::Measurement(m); }, sample)});
  return object;
}

void CallbackPeer::exchange(const pipeline::Step& step,
                            std::vector<pipeline::OutsideEstimate>& into) {
  ++account_.steps;
  const auto begun = std::chrono::steady_clock::now();
  call_python(failure_, [&] {
    read(callback_.call(object_of(step)), into);
    ++account_.answers;
  });
  const double took_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  account_.mean_s += (took_s - account_.mean_s) / static_cast<double>(account_.steps);
  account_.longest_s = std::max(account_.longest_s, took_s);
}

void CallbackPeer::read(py::handle answer, std::vector<pipeline::OutsideEstimate>& into) {
  if (answer.is_none()) return;
  const auto json = json_of(answer);
  const auto take = [&](const nlohmann::json& one) {
    external::EstimateReader reader(one, callback_.gives);
    const auto estimate = reader.read();
    if (reader.flaw() != external::Answer::Flaw::none)
      throw std::invalid_argument(
          fmt::format("estimator {} gave {}", callback_.name, reader.what()));
    into.push_back(estimate);
  };
  if (!json.is_array()) return take(json);
  for (const auto& one : json) take(one);
}

void CallbackPeer::refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) {
  ++account_.out_of_time;
  failure_.keep(std::make_exception_ptr(std::invalid_argument(fmt::format(
      "estimator {} gave an estimate with valid_at_ns = {}, allowed: up to {}, the end of the "
      "step, and not before its last one",
      callback_.name, pipeline::valid_at(estimate).time_since_epoch().count(),
      now.time_since_epoch().count()))));
}

void add_step_object(py::module_& module) {
  py::class_<StepObject>(module, "Step")
      .def_readonly("number", &StepObject::number)
      .def_readonly("now_ns", &StepObject::now_ns)
      .def_readonly("measurements", &StepObject::measurements);
}

}  // namespace drydock::python
