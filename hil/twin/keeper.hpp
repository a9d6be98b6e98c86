#pragma once

#include <vector>

#include "hil/bench/follower.hpp"

namespace drydock::twin {

/// The measurements of each device, in the order in which they came.
using ByDevice = std::vector<std::vector<measurement::Measurement>>;

/// Keeps what sensors measured. Signals of satellites are left out.
class Keeper final : public bench::Follower {
 public:
  void on_measurement(const measurement::Measurement& measurement) override {
    if (std::holds_alternative<measurement::GnssSatellites>(measurement)) return;
    const auto device = measurement::origin_of(measurement).device;
    if (kept_.size() <= device) kept_.resize(device + 1u);
    kept_[device].push_back(measurement);
  }

  const ByDevice& kept() const { return kept_; }

 private:
  ByDevice kept_;
};

}  // namespace drydock::twin
