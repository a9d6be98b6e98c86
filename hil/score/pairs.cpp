#include "hil/score/pairs.hpp"

#include <algorithm>

#include "hil/score/attitude.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

/// Without all three angles each of them goes its own way.
Vector3d angles_between(const State& before, const State& after, double share) {
  const auto from = attitude_of(before), to = attitude_of(after);
  if (from && to) return angles_of(from->slerp(share, *to));
  return before.angles + share * turns_between(before.angles, after.angles);
}

std::optional<State> truth_at(const Track& truth, measurement::Stamp at,
                              std::chrono::nanoseconds longest_gap, Pairs& account) {
  const auto after = std::ranges::lower_bound(truth, at, {}, &State::at);
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
  const auto between = [share](const Vector3d& a, const Vector3d& b) -> Vector3d {
    return a + share * (b - a);
  };
  State state;
  state.at = at;
  state.position_ned = between(before->position_ned, after->position_ned);
  state.angles = angles_between(*before, *after, share);
  state.velocity = between(before->velocity, after->velocity);
  return state;
}

}  // namespace

Pairs pairs_of(const Track& estimates, const Track& truth, std::chrono::nanoseconds longest_gap) {
  Pairs pairs;
  auto last = measurement::Stamp::min();
  for (const State& estimate : estimates) {
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
