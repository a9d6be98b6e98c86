#pragma once

#include <chrono>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// Remembers since when, and until when, something contradicted an estimator. Times are valid_at.
class Trust {
 public:
  /// What contradicted is believed again after this time without a contradiction.
  static constexpr std::chrono::seconds settled_after{5};

  void judge(bool contradicts, measurement::Stamp now) {
    if (!contradicts) {
      since_.reset();
      return;
    }
    if (!since_) since_ = now;
    last_ = now;
  }
  /// It contradicts no more.
  void end() { since_.reset(); }
  void forget() { *this = {}; }

  bool contradicted(measurement::Stamp now, std::chrono::nanoseconds within) const {
    return last_ && now - *last_ <= within;
  }
  bool settled(measurement::Stamp now) const { return !contradicted(now, settled_after); }
  /// For how long it has contradicted without a pause; 0: it does not.
  std::chrono::nanoseconds doubted(measurement::Stamp now) const {
    return since_ ? now - *since_ : std::chrono::nanoseconds::zero();
  }

 private:
  std::optional<measurement::Stamp> since_, last_;
};

}  // namespace drydock::pipeline
