#include "hil/score/pairs.hpp"

#include <algorithm>

namespace drydock::score {
namespace {

std::optional<Pose> truth_at(const Track& truth, measurement::Stamp at,
                             std::chrono::nanoseconds longest_gap, Pairs& account) {
  const auto after = std::ranges::lower_bound(truth, at, {}, &Pose::at);
  if (after == truth.end()) return {};
  if (after->at == at) return *after;
  if (after == truth.begin()) return {};
  const auto before = std::prev(after);
  if (after->at - before->at > longest_gap) {
    ++account.in_gaps;
    account.widest_gap_s =
        std::max(account.widest_gap_s, measurement::seconds(after->at - before->at));
    return {};
  }
  const double share =
      measurement::seconds(at - before->at) / measurement::seconds(after->at - before->at);
  Pose pose{
      at, before->position_ned + share * (after->position_ned - before->position_ned), {}, {}};
  if (before->body_to_ned && after->body_to_ned)
    pose.body_to_ned = before->body_to_ned->slerp(share, *after->body_to_ned);
  return pose;
}

}  // namespace

Pairs pairs_of(const Track& estimates, const Track& truth, std::chrono::nanoseconds longest_gap) {
  Pairs pairs;
  auto last = measurement::Stamp::min();
  for (const Pose& estimate : estimates) {
    if (estimate.at <= last) {
      ++pairs.out_of_order;
      continue;
    }
    last = estimate.at;
    if (const auto there = truth_at(truth, estimate.at, longest_gap, pairs))
      pairs.all.push_back({estimate, *there});
    else
      ++pairs.without_truth;
  }
  return pairs;
}

}  // namespace drydock::score
