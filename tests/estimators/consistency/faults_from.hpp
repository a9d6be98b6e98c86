#pragma once

#include <functional>
#include <numbers>
#include <variant>

#include "tests/estimators/consistency/voyage.hpp"

namespace drydock::consistency::test {

inline constexpr double begin_s = 70, degree = std::numbers::pi / 180;

/// A fault of all samples of a type from `begin_s` on.
template <class Sample>
Voyage::Fault on(const std::function<void(Sample&, double since_s)>& change) {
  return [change](measurement::Measurement& measurement, double t) {
    if (auto* sample = std::get_if<Sample>(&measurement); sample != nullptr && t >= begin_s)
      change(*sample, t - begin_s);
  };
}

/// The same from the first sample on.
template <class Sample>
Voyage::Fault from_the_start(const std::function<void(Sample&)>& change) {
  return [change](measurement::Measurement& measurement, double) {
    if (auto* sample = std::get_if<Sample>(&measurement)) change(*sample);
  };
}

}  // namespace drydock::consistency::test
