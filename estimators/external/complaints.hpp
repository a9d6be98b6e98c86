#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/measurement/stamp.hpp"

namespace drydock::external {

/// Why an estimate that is valid so long after the end of its step was refused.
std::string out_of_time(double after_s);

/// Says what another program did wrong: the first time of each sort, so that a program that goes on
/// doing it does not flood the terminal. The account has the numbers.
class Complaints {
 public:
  Complaints(std::string estimator, std::function<void(const std::string&)> say);

  void began(measurement::Stamp start) {
    if (!start_) start_ = start;
  }
  void now(measurement::Stamp now) { now_ = now; }
  /// Seconds since the first step.
  double seconds() const;
  /// Counts, and says it if it is the first of its sort.
  void add(std::uint64_t& count, std::string_view what);
  void say(std::string_view what) const;

 private:
  std::string estimator_;
  std::function<void(const std::string&)> say_;
  std::optional<measurement::Stamp> start_;
  measurement::Stamp now_{};
};

}  // namespace drydock::external
