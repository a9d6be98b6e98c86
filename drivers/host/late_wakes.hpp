#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// How often this computer was late enough to matter to a diagnosis, for the end of a run.
class LateWakes final : public Follower {
 public:
  /// No raster of messages tolerates less.
  static constexpr std::chrono::milliseconds least{2};

  void on_late_wake(Stamp due, Stamp woke) override {
    if (woke - due < least) return;
    ++count_;
    most_ = std::max(most_, woke - due);
  }

  /// One line; empty: it was in time.
  std::string note() const;

 private:
  std::uint64_t count_ = 0;
  std::chrono::nanoseconds most_{0};
};

}  // namespace drydock::host
