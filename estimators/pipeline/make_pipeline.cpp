#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "estimators/pipeline/inertial/navigation_estimator.hpp"
#include "estimators/pipeline/leveling_estimator.hpp"
#include "estimators/pipeline/mixing_estimator.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/pipeline/roll_estimator.hpp"

namespace drydock::pipeline {

namespace {

/// The number of bits of AttitudeEstimate::fed_by.
constexpr int max_devices = 32;

constexpr std::array<std::string_view, 5> kinds{"leveling", "mixing", "roll", "navigation",
                                                "velocity"};

/// Checks options of the kinds "navigation" and "velocity". Empty: no fault.
std::string inertial_fault(const EstimatorOptions& options) {
  const InertialOptions& inertial = options.inertial;
  const auto index = [](const auto& sensor) { return sensor ? sensor->device : 0; };
  if (std::max({index(inertial.ground), index(inertial.log), index(inertial.depth),
                index(inertial.gnss), static_cast<int>(inertial.actuators.value_or(0))}) >=
      max_devices)
    return fmt::format("device index out of range, allowed: 0 to {}", max_devices - 1);
  if (!(inertial.imu_period_s > 0)) return "IMU period not above 0, allowed: seconds";
  if (options.kind == "navigation") {
    return inertial.ground || inertial.depth || inertial.gnss
               ? ""
               : "nothing aids it, allowed: dvl, depth, gnss = devices, one at least";
  }
  return inertial.log && inertial.depth && inertial.actuators
             ? ""
             : "velocity needs log, depth and actuators, allowed: = devices";
}

/// Empty: no fault.
std::string fault_of(const EstimatorOptions& options) {
  if (std::ranges::find(kinds, options.kind) == kinds.end()) {
    return fmt::format("kind '{}' is not known, allowed: {}", options.kind, fmt::join(kinds, ", "));
  }
  if (options.kind == "mixing" && options.stationary) {
    return "mixing knows no stationary vehicle, allowed: log = a device";
  }
  if (options.imu >= max_devices || options.log.value_or(0) >= max_devices ||
      options.gnss.value_or(0) >= max_devices) {
    return fmt::format("device index out of range, allowed: 0 to {}", max_devices - 1);
  }
  if (options.kind == "navigation" || options.kind == "velocity") return inertial_fault(options);
  if (options.kind == "roll") {
    return options.gnss ? "" : "roll needs a satellite receiver, allowed: gnss = a device";
  }
  if (!options.stationary && !options.log) {
    return "a moving vehicle needs a speed log, allowed: log = a device, or stationary = true";
  }
  return {};
}

std::unique_ptr<Estimator> make_estimator(std::uint16_t index, const EstimatorOptions& options,
                                          const PipelineOptions& pipeline) {
  if (options.kind == "navigation" || options.kind == "velocity")
    return std::make_unique<NavigationEstimator>(index, options, pipeline);
  if (options.kind == "roll") return std::make_unique<RollEstimator>(index, options, pipeline);
  if (options.kind == "mixing") return std::make_unique<MixingEstimator>(index, options, pipeline);
  return std::make_unique<LevelingEstimator>(index, options, pipeline);
}

}  // namespace

boost::system::result<Pipeline, PipelineError> make_pipeline(const PipelineOptions& options,
                                                             EstimateListener& listener) {
  if (options.reorder_window < std::chrono::nanoseconds::zero() || options.reorder_capacity == 0) {
    return PipelineError{"reorder window below 0 or capacity 0, allowed: 0 s or more, 1 or more"};
  }
  std::vector<std::unique_ptr<Estimator>> estimators;
  for (const EstimatorOptions& estimator : options.estimators) {
    if (const std::string fault = fault_of(estimator); !fault.empty()) {
      return PipelineError{fmt::format("estimator '{}': {}", estimator.name, fault)};
    }
    const auto index = static_cast<std::uint16_t>(estimators.size());
    estimators.push_back(make_estimator(index, estimator, options));
  }
  return Pipeline{options, listener, std::move(estimators)};
}

}  // namespace drydock::pipeline
