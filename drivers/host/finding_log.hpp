#pragma once

#include <cstdint>
#include <vector>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Keeps the findings of a run, in the order in which they were found.
class FindingLog final : public Follower {
 public:
  static constexpr std::size_t most = 1'000;  ///< further ones are counted only

  void on_finding(const diagnosis::Finding& finding) override;
  /// The findings kept so far have the new time from then on.
  void on_clock_step(std::chrono::nanoseconds step) override;

  const std::vector<diagnosis::Finding>& all() const { return all_; }
  std::uint64_t not_kept() const { return not_kept_; }
  /// By how much the host's clock was set in all: a start of the old time began so much later.
  std::chrono::nanoseconds stepped() const { return stepped_; }
  /// The finding of a device that lasts; null: none.
  const diagnosis::Finding* open(std::uint16_t device) const;

 private:
  diagnosis::Finding* last_open(std::uint16_t device, diagnosis::Cause cause);

  std::vector<diagnosis::Finding> all_;
  std::uint64_t not_kept_ = 0;
  std::chrono::nanoseconds stepped_{0};
};

}  // namespace drydock::host
