#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hil/campaign/plan/campaign_file.hpp"

namespace drydock::campaign {

/// Which run has which values. They depend on the campaign's file and the run's index alone.
/// Repetitions of one combination stand together; the last list changes fastest.
class Plan {
 public:
  explicit Plan(const CampaignConfig& campaign);

  std::size_t runs() const { return combinations_ * campaign_->repetitions; }
  std::size_t repetition_of(std::size_t index) const { return index % campaign_->repetitions; }
  std::uint64_t seed_of(std::size_t index) const { return campaign_->seed + index; }
  /// The value of each parameter, in the order of the file.
  std::vector<Value> values_of(std::size_t index) const;

 private:
  const CampaignConfig* campaign_;  // outlives the plan
  std::size_t combinations_ = 1;
};

}  // namespace drydock::campaign
