#include "hil/check/check_rig.hpp"

#include <fmt/format.h>
#include <net/if.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "drivers/link/clock.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/check/check_devices.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/ocean/raster.hpp"
#include "hil/pilot/pilot.hpp"
#include "rig_config/steering.hpp"

namespace drydock::check {

namespace {

using measurement::Stamp;
using rig_config::Problem;
using rig_config::problem_at;
using rig_config::Problems;
using rig_config::Rig;

void append(Problems& to, Problems more) { std::ranges::move(more, std::back_inserter(to)); }

class NoEstimates final : public pipeline::EstimateListener {
  void on_attitude(const pipeline::AttitudeEstimate&) override {}
};

/// Each estimator alone, so that every one that cannot be made is told.
Problems check_estimators(const Rig& rig) {
  const auto all = setup::pipeline_options(rig);
  NoEstimates nobody;
  Problems problems;
  for (std::size_t i = 0; i < all.estimators.size(); ++i) {
    const auto refuse = [&](const std::string& key, const std::string& why) {
      problems.push_back(problem_at(rig.places, fmt::format("/estimator/{}{}", i, key), why));
    };
    auto one = all;
    one.estimators = {all.estimators[i]};
    try {
      if (const auto made = pipeline::make_pipeline(one, nobody); !made)
        refuse("", made.error().message);
    } catch (const std::invalid_argument& error) {  // of the vehicle's equations of motion
      refuse("/vehicle", error.what());
    }
  }
  return problems;
}

/// The motion of a mission, or nothing and its problem.
std::unique_ptr<motion::Trajectory> trajectory_of(const rig_config::MissionConfig& mission,
                                                  Stamp start, Problems& problems) {
  const auto refuse = [&](const std::string& path, const std::exception& error) {
    problems.push_back(problem_at(mission.places, path, error.what()));
  };
  try {
    return motion::make_trajectory(mission, start);
  } catch (const motion::BadMission& error) {
    refuse(error.path, error);
  } catch (const ocean::BadRaster& error) {
    refuse("/ocean/bed/file", error);
  } catch (const std::invalid_argument& error) {  // of the vehicle's equations of motion
    refuse("/mission/vehicle", error);
  }
  return nullptr;
}

/// What stops the vehicle and the emulated devices of the rig at this start.
Problems check_emulated(const Rig& rig, Stamp start) {
  Problems problems;
  const auto trajectory = trajectory_of(rig.mission, start, problems);
  if (!trajectory) return problems;
  fault::Injector injector(rig, *trajectory, start);
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    if (!is_emulated(rig.devices[i])) continue;
    if (const auto made = injector.device(rig.devices[i]); !made)
      problems.push_back(problem_at(rig.places, fmt::format("/device/{}/{}", i, made.error().key),
                                    made.error().message));
  }
  return problems;
}

Problems check_interface(const Rig& rig) {
  if (rig.dds_interface.empty() || ::if_nametoindex(rig.dds_interface.c_str()) != 0) return {};
  return {problem_at(rig.places, "/rig/dds_interface",
                     fmt::format("this machine has no network interface \"{}\"; ip link lists them",
                                 rig.dds_interface))};
}

Problems check_some_device_is_emulated(const Rig& rig) {
  if (std::ranges::any_of(rig.devices, is_emulated)) return {};
  return {problem_at(rig.places, "/device",
                     "no device has an emulated link (pty, memory, memory-can, can:auto)")};
}

/// The sky over a receiver depends on the time: some rigs start in virtual time alone, some in real
/// time alone.
Problems check_start(const Rig& rig, Use use) {
  const Stamp in_virtual_time = measurement::stamp_from_ns(rig.start_utc_ns);
  if (use == Use::lockstep) return check_emulated(rig, in_virtual_time);
  if (use != Use::any) return check_emulated(rig, link::steady_now());
  if (!check_virtual_time(rig).empty()) return check_emulated(rig, link::steady_now());
  Problems problems = check_emulated(rig, in_virtual_time);
  if (!problems.empty() && check_emulated(rig, link::steady_now()).empty()) problems.clear();
  return problems;
}

/// What an autopilot at the drivers' end of the wires lacks.
Problems check_pilot(const Rig& rig) {
  if (!pilot::is_wanted(rig)) return {};
  try {
    const pilot::Pilot sails(rig, {}, {}, {});
  } catch (const std::runtime_error& error) {
    return {problem_at(rig.places, "/device", error.what())};
  } catch (const motion::BadMission&) {  // which the motion tells
  }
  return {};
}

/// A program on standard input and output waits for nobody's clock.
Problems check_steering(const Rig& rig, Use use) {
  const bool in_real_time = use == Use::real_time || use == Use::emulation;
  if (!in_real_time || !rig_config::steered_by_program(rig.mission)) return {};
  return {problem_at(rig.mission.places, "/steering/from",
                     "a program steers in virtual time alone: allowed with run --speed max; in "
                     "real time: \"dds\", \"wires\", \"ardupilot\"")};
}

}  // namespace

Problems check_mission(const rig_config::MissionConfig& mission) {
  Problems problems;
  trajectory_of(mission, Stamp{}, problems);
  return problems;
}

Problems check_rig(const Rig& rig, Use use) {
  Problems problems = check_devices(rig);
  append(problems, use == Use::lockstep ? check_virtual_time(rig) : check_interface(rig));
  if (use == Use::emulation) append(problems, check_some_device_is_emulated(rig));
  append(problems, check_estimators(rig));
  append(problems, check_steering(rig, use));
  append(problems, fault::check_faults(rig));
  if (use != Use::emulation) append(problems, check_pilot(rig));  // else another program steers
  append(problems, problems.empty() ? check_start(rig, use) : check_mission(rig.mission));
  std::ranges::stable_sort(problems, {}, [](const Problem& problem) {
    return std::tuple(problem.file, problem.line, problem.column);
  });
  return problems;
}

}  // namespace drydock::check
