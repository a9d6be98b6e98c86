#include "drivers/device/described/sample_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace drydock::device {
namespace {

constexpr double vote_memory = 1 - 1.0 / 256;
constexpr double clear_votes = 2.9, clear_share = 2.0 / 3;  // three of one mind

}  // namespace

void SampleOrder::hear(unsigned frame, measurement::Stamp at) {
  const auto last = last_at_;
  last_at_ = at;
  const std::uint64_t bit = std::uint64_t{1} << frame;
  if ((heard_ & bit) != 0) {
    judge_pauses();
    heard_ = 0;
  }
  if (!last || at < *last) {
    heard_ = 0;
    return;
  }
  heard_ |= bit;
  pause_.at(frame) = at - *last;
}

/// Votes for the frame behind a pause that is clearly the longest of the round.
void SampleOrder::judge_pauses() {
  using Pause = measurement::Stamp::duration;
  unsigned longest = 0;
  Pause longest_pause{-1}, next_pause{0};
  for (std::uint64_t rest = heard_; rest != 0; rest &= rest - 1) {
    const auto frame = static_cast<unsigned>(std::countr_zero(rest));
    next_pause = std::max(next_pause, std::min(pause_[frame], longest_pause));
    if (pause_[frame] <= longest_pause) continue;
    longest_pause = pause_[frame];
    longest = frame;
  }
  if (std::popcount(heard_) > 1 && 2 * longest_pause > 3 * next_pause) vote(longest);
}

void SampleOrder::vote(unsigned frame) {
  for (double& votes : votes_) votes *= vote_memory;
  ++votes_[frame];
  const double all = std::accumulate(votes_.begin(), votes_.end(), 0.0);
  const auto most = std::ranges::max_element(votes_);
  const bool clear = all >= clear_votes && *most > clear_share * all;
  first_ = clear ? std::optional(static_cast<unsigned>(most - votes_.begin())) : std::nullopt;
}

}  // namespace drydock::device
