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

  const std::vector<diagnosis::Finding>& all() const { return all_; }
  std::uint64_t not_kept() const { return not_kept_; }
  /// The finding of a device that lasts; null: none.
  const diagnosis::Finding* open(std::uint16_t device) const;

 private:
  diagnosis::Finding* last_open(std::uint16_t device, diagnosis::Cause cause);

  std::vector<diagnosis::Finding> all_;
  std::uint64_t not_kept_ = 0;
};

}  // namespace drydock::host
