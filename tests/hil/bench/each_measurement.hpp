#pragma once

#include <functional>

#include "hil/bench/follower.hpp"

namespace drydock::bench {

/// Calls a function for each measurement of a run.
class EachMeasurement final : public Follower {
 public:
  explicit EachMeasurement(std::function<void(const measurement::Measurement&)> call)
      : call_(std::move(call)) {}
  void on_measurement(const measurement::Measurement& m) override { call_(m); }

 private:
  std::function<void(const measurement::Measurement&)> call_;
};

}  // namespace drydock::bench
