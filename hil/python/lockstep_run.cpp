#include "hil/python/lockstep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "drivers/text/printable.hpp"
#include "hil/bench/run.hpp"
#include "hil/check/check_rig.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/values.hpp"
#include "rig_config/estimator_name.hpp"
#include "rig_config/load.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::python {
namespace {

using rig_config::Rig;

void refuse(const rig_config::Problems& problems) {
  if (problems.empty()) return;
  std::string lines;
  for (const auto& problem : problems) lines += (lines.empty() ? "" : "\n") + to_string(problem);
  throw std::invalid_argument(lines);
}

/// A function takes the place of an external estimator of its name, or stands beside the others.
void seat(const EstimatorCallback& callback, Rig& rig) {
  if (!rig_config::may_be_estimator(callback.name))
    throw std::invalid_argument(fmt::format(
        "an estimator is named \"{}\", allowed: a letter, then letters, digits, _; not truth",
        text::printable(callback.name)));
  auto place = std::ranges::find(rig.estimators, callback.name, &rig_config::EstimatorConfig::name);
  if (place == rig.estimators.end())
    place = rig.estimators.insert(place, rig_config::EstimatorConfig{callback.name, {}, {}});
  else if (!std::holds_alternative<rig_config::ExternalConfig>(place->kind))
    throw std::invalid_argument(
        fmt::format("{} has an estimator {} of its own, allowed: another name, or kind external",
                    rig.file, callback.name));
  rig_config::ExternalConfig external;
  external.gives = callback.gives;
  external.step_s = callback.step_s;
  place->kind = external;
}

void steer(Rig& rig) {
  rig.mission.steering.reset();
  if (!rig.mission.vehicle && !rig.mission.thruster_vehicle)
    throw std::invalid_argument(rig.file +
                                ": its mission has no vehicle, which a controller needs; allowed: "
                                "the key vehicle in the mission file");
}

Rig rig_of(const std::string& file, const LockstepOptions& options) {
  auto loaded = check::load_sound_rig(rig_config::find_shipped(file, rig_config::rigs));
  if (!loaded) refuse(loaded.error());
  Rig rig = std::move(*loaded);
  if (options.seed) rig.seed = *options.seed;
  if (!options.faults.empty()) {
    auto faults = rig_config::load_faults_text(options.faults, "faults");
    if (!faults) refuse(faults.error());
    std::ranges::move(*faults, std::back_inserter(rig.faults));
    refuse(fault::check_faults(rig));
  }
  if (options.controller) steer(rig);
  for (const auto& estimator : options.estimators) seat(estimator, rig);
  return rig;
}

template <class Named>
std::shared_ptr<const std::vector<std::string>> names_of(const std::vector<Named>& all) {
  auto names = std::make_shared<std::vector<std::string>>(all.size());
  std::ranges::transform(all, names->begin(), &Named::name);
  return names;
}

}  // namespace

LockstepRun::LockstepRun(const std::string& file, const LockstepOptions& options)
    : options_(options),
      rig_(rig_of(file, options)),
      names_{names_of(rig_.devices), names_of(rig_.estimators)},
      log_(rig_.estimators.size()) {
  const auto start = measurement::stamp_from_ns(rig_.start_utc_ns);
  if (options.controller) {
    auto steered = std::make_unique<motion::SteeredTrajectory>(rig_.mission, start);
    steerer_.emplace(*options.controller, *steered, log_, motion::outputs_of(rig_.mission), names_,
                     failure_);
    motion_ = std::move(steered);
  } else {
    motion_ = motion::make_trajectory(rig_.mission, start);
  }
  truth_.emplace(*motion_, options.truth_period);
}

void LockstepRun::run() {
  bench::RunOptions run;
  run.duration_s = options_.duration_s;
  run.lockstep = run.quiet = true;
  run.record = options_.record;
  run.followers = {&log_};
  const motion::RememberedTrajectory remembered(std::move(motion_));
  run.parts.motion = &remembered;
  if (steerer_) run.parts.actors.push_back(&*steerer_);
  run.parts.actors.push_back(&*truth_);
  for (const auto& estimator : options_.estimators)
    run.parts.peers[estimator.name] = [&] {
      return std::make_unique<CallbackPeer>(estimator, names_.devices, failure_);
    };
  run.parts.stopped = [this] { return failure_.is(); };
  run.parts.progress = false;
  summary_ = run_lockstep(rig_, run);
}

py::dict LockstepRun::take() {
  failure_.throw_if_any();
  throw_if_ended();
  py::dict result;
  result["summary"] = value_of_json(to_json(summary_));
  result["measurements"] = log_.take_measurements(*names_.devices);
  result["estimates"] = log_.take_estimates(*names_.estimators);
  result["truth"] = truth_->take();
  return result;
}

}  // namespace drydock::python
