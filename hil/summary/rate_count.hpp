#pragma once

#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::summary {

/// The mean rate of what comes at these times.
class RateCount {
 public:
  void add(measurement::Stamp at) {
    if (count_++ == 0) first_ = at;
    last_ = at;
  }
  /// Empty: fewer than two, or all at one time.
  std::optional<double> hz() const {
    if (count_ < 2 || last_ <= first_) return {};
    return static_cast<double>(count_ - 1) / measurement::seconds(last_ - first_);
  }

 private:
  std::uint64_t count_ = 0;
  measurement::Stamp first_{}, last_{};
};

}  // namespace drydock::summary
