#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "hil/fault/wire/damage.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

/// A wire with a delay: messages come later by a constant or random time, or together in bursts.
/// Their order stays. A message that waits when a fault ends still comes at its own time.
template <class Carried>
class HeldMessages {
 public:
  HeldMessages(std::uint64_t seed, std::string device) : seed_(seed), device_(std::move(device)) {}

  void set(const std::vector<InForce>& faults);
  /// `counts`: true if it is a message and counts as a hit.
  void put(const Carried& message, Stamp now, std::optional<Stamp> sampled_at = {},
           bool counts = true);
  std::optional<Stamp> deadline() const;   ///< time of the next message
  std::optional<Carried> take(Stamp now);  ///< the next message that is due
  /// The value given to put() with the last message that was taken.
  std::optional<Stamp> sampled_at() const { return sampled_at_; }
  void drop_all() { waiting_.clear(); }
  bool empty() const { return waiting_.empty(); }
  const FaultHits& hits() const { return hits_; }

 private:
  struct Waiting {
    Stamp due{};
    Carried message;
    std::optional<Stamp> sampled_at;
  };

  Stamp due(Stamp now);

  std::uint64_t seed_;
  std::string device_;
  std::chrono::nanoseconds delay_{0}, jitter_{0}, burst_{0};
  Stamp burst_since_{};
  std::optional<RandomStream> random_;
  std::deque<Waiting> waiting_;
  std::optional<Stamp> sampled_at_;
  FaultHits hits_;
};

template <class Carried>
void HeldMessages<Carried>::set(const std::vector<InForce>& faults) {
  delay_ = jitter_ = burst_ = {};
  for (const InForce& now : faults) {
    const auto amount = measurement::from_seconds(now.fault->amount[0]);
    if (now.fault->kind == FaultKind::delay) delay_ = amount;
    if (now.fault->kind == FaultKind::jitter) {
      jitter_ = amount;
      if (!random_) random_.emplace(seed_ ^ now.fault->seed, device_, "jitter");
    }
    if (now.fault->kind == FaultKind::burst) {
      burst_ = amount;
      burst_since_ = now.since;
    }
  }
}

template <class Carried>
Stamp HeldMessages<Carried>::due(Stamp now) {
  Stamp at = now + delay_;
  if (jitter_.count() > 0)
    at += std::chrono::nanoseconds{
        static_cast<std::int64_t>(random_->uniform() * static_cast<double>(jitter_.count()))};
  if (burst_.count() > 0) at = burst_since_ + ((at - burst_since_) / burst_ + 1) * burst_;
  return waiting_.empty() ? at : std::max(at, waiting_.back().due);
}

template <class Carried>
void HeldMessages<Carried>::put(const Carried& message, Stamp now, std::optional<Stamp> sampled_at,
                                bool counts) {
  hits_[FaultKind::delay] += counts && delay_.count() > 0;
  hits_[FaultKind::jitter] += counts && jitter_.count() > 0;
  hits_[FaultKind::burst] += counts && burst_.count() > 0;
  waiting_.push_back({due(now), message, sampled_at});
}

template <class Carried>
std::optional<Stamp> HeldMessages<Carried>::deadline() const {
  return waiting_.empty() ? std::nullopt : std::optional(waiting_.front().due);
}

template <class Carried>
std::optional<Carried> HeldMessages<Carried>::take(Stamp now) {
  if (waiting_.empty() || waiting_.front().due > now) return {};
  Carried message = std::move(waiting_.front().message);
  sampled_at_ = waiting_.front().sampled_at;
  waiting_.pop_front();
  return message;
}

}  // namespace drydock::fault
