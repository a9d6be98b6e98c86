#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hil/bench/follower.hpp"
#include "hil/python/columns.hpp"
#include "hil/python/measurement_tables.hpp"

namespace drydock::python {

/// Keeps what a run's drivers and estimators gave.
class RunLog final : public bench::Follower {
 public:
  explicit RunLog(std::size_t estimators) : estimates_(estimators), latest_(estimators) {}

  /// Collects for a controller too.
  void listen() { listens_ = true; }

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_estimate(const host::Estimate& estimate) override;

  /// What came since the last call, in the order of arrival.
  std::vector<measurement::Measurement> heard() { return std::exchange(heard_, {}); }
  /// The newest estimate of each estimator of the rig.
  const std::vector<std::optional<host::Estimate>>& latest() const { return latest_; }

  py::dict take_measurements(std::span<const std::string> devices) {
    return measurements_.take(devices);
  }
  py::dict take_estimates(std::span<const std::string> estimators);

 private:
  MeasurementTables measurements_;
  std::vector<Columns> estimates_;
  bool listens_ = false;
  std::vector<measurement::Measurement> heard_;
  std::vector<std::optional<host::Estimate>> latest_;
};

}  // namespace drydock::python
