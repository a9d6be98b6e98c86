#include "hil/python/steerer.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hil/python/estimate_fields.hpp"
#include "hil/python/measurement_object.hpp"
#include "hil/python/truth_fields.hpp"
#include "hil/python/values.hpp"

namespace drydock::python {
namespace {

using measurement::Stamp;

/// The sensors see the motion between two moments as linear.
constexpr std::chrono::milliseconds longest_step{10};

/// What a controller sees. Its parts become Python values when they are asked for.
struct MomentObject {
  std::int64_t now_ns = 0;
  double time_s = 0;
  std::vector<measurement::Measurement> heard;
  std::vector<std::optional<host::Estimate>> latest;
  motion::Truth truth;
  RunNames names;
};

py::list measurements(const MomentObject& moment) {
  py::list list;
  for (const auto& m : moment.heard) list.append(MeasurementObject{moment.names.devices, m});
  return list;
}

py::dict estimates(const MomentObject& moment) {
  py::dict dict;
  for (std::size_t i = 0; i < moment.latest.size(); ++i)
    if (moment.latest[i]) dict[py::str((*moment.names.estimators)[i])] = dict_of(*moment.latest[i]);
  return dict;
}

std::vector<double> outputs_in(const py::object& answer) {
  py::detail::make_caster<std::vector<double>> caster;
  if (caster.load(answer, true))
    return py::detail::cast_op<std::vector<double>&&>(std::move(caster));
  throw std::invalid_argument(fmt::format("the controller gave {}, allowed: a list of numbers",
                                          py::repr(answer).cast<std::string>().substr(0, 80)));
}

}  // namespace

Steerer::Steerer(const Controller& controller, motion::SteeredTrajectory& motion, RunLog& log,
                 std::size_t outputs, const RunNames& names, Failure& failure)
    : controller_(controller),
      motion_(motion),
      log_(log),
      most_outputs_(outputs),
      names_(names),
      failure_(failure),
      next_(motion.start()) {
  log_.listen();
}

std::vector<double> Steerer::ask(Stamp now) {
  MomentObject moment{now.time_since_epoch().count(),
                      measurement::seconds(now - motion_.start()),
                      log_.heard(),
                      log_.latest(),
                      motion_.at(now),
                      names_};
  const py::object answer = controller_.call(py::cast(std::move(moment)));
  auto outputs = outputs_in(answer);
  if (outputs.size() > most_outputs_)
    throw std::invalid_argument(
        fmt::format("the controller gave {} outputs, allowed: at most the {} of the vehicle",
                    outputs.size(), most_outputs_));
  for (const double output : outputs)
    if (!(std::abs(output) <= 1))
      throw std::invalid_argument(
          fmt::format("the controller gave an output of {}, allowed: -1 to 1", output));
  return outputs;
}

/// The motion until the next call is known before a sensor asks for it.
void Steerer::act(Stamp now) {
  call_python(failure_, [&] { outputs_ = ask(now); });
  const Stamp end = now + controller_.period;
  for (Stamp at = now; at < end;) {
    const auto step = std::min<std::chrono::nanoseconds>(longest_step, end - at);
    at += step;
    motion_.step(outputs_, measurement::seconds(step), at);
  }
  next_ = end;
}

void add_moment_object(py::module_& module) {
  py::class_<MomentObject>(module, "Moment")
      .def_readonly("now_ns", &MomentObject::now_ns)
      .def_readonly("time_s", &MomentObject::time_s)
      .def_property_readonly("measurements", &measurements)
      .def_property_readonly("estimates", &estimates)
      .def_property_readonly("truth", [](const MomentObject& m) { return dict_of(m.truth); });
}

}  // namespace drydock::python
