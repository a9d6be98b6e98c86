#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include "estimators/pipeline/estimator.hpp"

namespace drydock::pipeline {

struct PipelineOptions;

/// What every estimator has: an index, which identifies its estimates, and the device index of its
/// IMU.
struct Seat {
  std::uint16_t index = 0, imu = 0;
};

/// Every kind of options has two functions beside it. The compiler finds them when it visits
/// EstimatorKind:
///
///   std::string fault_of(const Options&);
///   std::unique_ptr<Estimator> make_estimator(Seat, const Options&, const PipelineOptions&);
///
/// `fault_of` says in words what is wrong and what is allowed; empty: no fault.

/// The fault of device indices that have no bit in AttitudeEstimate::fed_by. Empty: no fault.
std::string fault_of_devices(std::initializer_list<std::optional<std::uint16_t>> devices);

}  // namespace drydock::pipeline
