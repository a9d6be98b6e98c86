#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <stdexcept>

#include "hil/python/lockstep_run.hpp"
#include "hil/python/measurement_object.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"

namespace drydock::python {
namespace {

external::Gives gives_of(const std::string& name) {
  const auto& names = rig_config::external_gives_names;
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw std::invalid_argument(
        fmt::format("an estimator that gives \"{}\", allowed: {}", name, fmt::join(names, ", ")));
  return static_cast<external::Gives>(found - names.begin());
}

std::chrono::nanoseconds period_of(double seconds, const char* name) {
  if (!(seconds >= 1e-6 && seconds < 1e6))
    throw std::invalid_argument(fmt::format("{} = {}, allowed: 1e-6 to 1e6 s", name, seconds));
  return measurement::from_seconds(seconds);
}

using EstimatorTuple = std::tuple<py::function, std::string, double>;

py::dict run(const std::string& rig, std::optional<double> duration_s,
             const std::map<std::string, EstimatorTuple>& estimators,
             const std::optional<py::function>& controller, double controller_period_s,
             double truth_period_s, std::optional<std::uint64_t> seed, const std::string& faults,
             const std::string& record, bool overwrite) {
  LockstepOptions options;
  if (duration_s && !(*duration_s > 0 && *duration_s < 1e9))
    throw std::invalid_argument(
        fmt::format("duration_s = {}, allowed: above 0, below 1e9", *duration_s));
  if (controller && !duration_s)
    throw std::invalid_argument("a run with a controller has no end of its own: give duration_s");
  options.duration_s = duration_s.value_or(0);
  for (const auto& [name, estimator] : estimators) {
    const auto& [call, gives, step_s] = estimator;
    period_of(step_s, "step_s");
    options.estimators.push_back({name, call, gives_of(gives), step_s});
  }
  if (controller)
    options.controller = {*controller, period_of(controller_period_s, "controller_period_s")};
  options.truth_period = period_of(truth_period_s, "truth_period_s");
  options.seed = seed;
  options.faults = faults;
  options.record.path = record;
  options.record.overwrite = overwrite;

  std::optional<LockstepRun> lockstep;
  {
    const OutsidePython others_run;
    lockstep.emplace(rig, options);
    lockstep->run();
  }
  return lockstep->take();
}

}  // namespace

void add_lockstep(py::module_& module) {
  using py::arg;
  add_measurement_object(module);
  add_step_object(module);
  add_moment_object(module);
  module.def("run", &run, arg("rig"), arg("duration_s"), py::kw_only(), arg("estimators"),
             arg("controller"), arg("controller_period_s"), arg("truth_period_s"), arg("seed"),
             arg("faults"), arg("record"), arg("overwrite"));
}

}  // namespace drydock::python
