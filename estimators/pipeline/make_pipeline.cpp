#include <fmt/format.h>

#include <algorithm>
#include <boost/throw_exception.hpp>
#include <memory>
#include <stdexcept>
#include <utility>

#include "estimators/pipeline/pipeline.hpp"

namespace drydock::pipeline {

namespace {

/// The number of bits of AttitudeEstimate::fed_by.
constexpr int max_devices = 32;

/// Empty: no fault.
std::string fault_of_estimator(const EstimatorOptions& options) {
  const std::string fault = fault_of_devices({options.imu});
  return fault.empty() ? std::visit([](const auto& kind) { return fault_of(kind); }, options.kind)
                       : fault;
}

std::unique_ptr<Estimator> estimator_of(std::uint16_t index, const EstimatorOptions& options,
                                        const PipelineOptions& pipeline) {
  const Seat seat{.index = index, .imu = options.imu};
  return std::visit([&](const auto& kind) { return make_estimator(seat, kind, pipeline); },
                    options.kind);
}

}  // namespace

std::string fault_of_devices(std::initializer_list<std::optional<std::uint16_t>> devices) {
  const auto in_range = [](const auto& device) { return device.value_or(0) < max_devices; };
  if (std::ranges::all_of(devices, in_range)) return {};
  return fmt::format("device index out of range, allowed: 0 to {}", max_devices - 1);
}

void throw_exception_from_error(const PipelineError& error, const boost::source_location& where) {
  boost::throw_exception(std::invalid_argument(error.message), where);
}

boost::system::result<Pipeline, PipelineError> make_pipeline(const PipelineOptions& options,
                                                             EstimateListener& listener) {
  if (options.reorder_window < std::chrono::nanoseconds::zero() || options.reorder_capacity == 0) {
    return PipelineError{"reorder window below 0 or capacity 0, allowed: 0 s or more, 1 or more"};
  }
  std::vector<std::unique_ptr<Estimator>> estimators;
  for (const EstimatorOptions& estimator : options.estimators) {
    if (const std::string fault = fault_of_estimator(estimator); !fault.empty()) {
      return PipelineError{fmt::format("estimator '{}': {}", estimator.name, fault)};
    }
    const auto index = static_cast<std::uint16_t>(estimators.size());
    estimators.push_back(estimator_of(index, estimator, options));
  }
  return Pipeline{options, listener, std::move(estimators)};
}

}  // namespace drydock::pipeline
