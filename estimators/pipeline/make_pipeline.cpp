#include <fmt/format.h>

#include <memory>
#include <utility>

#include "estimators/pipeline/leveling_estimator.hpp"
#include "estimators/pipeline/mixing_estimator.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/pipeline/roll_estimator.hpp"

namespace drydock::pipeline {

namespace {

/// Bits of AttitudeEstimate::fed_by.
constexpr int max_devices = 32;

/// Empty: nothing is wrong.
std::string fault_of(const EstimatorOptions& options) {
  if (options.kind != "leveling" && options.kind != "mixing" && options.kind != "roll") {
    return fmt::format("kind '{}' is not known, allowed: leveling, mixing, roll", options.kind);
  }
  if (options.kind == "mixing" && options.stationary) {
    return "mixing knows no stationary vehicle, allowed: log = a device";
  }
  if (options.imu >= max_devices || options.log.value_or(0) >= max_devices ||
      options.gnss.value_or(0) >= max_devices) {
    return fmt::format("device index out of range, allowed: 0 to {}", max_devices - 1);
  }
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
