#pragma once

#include "hil/fault/wire/held_messages.hpp"
#include "hil/fault/wire/message_faults.hpp"

namespace drydock::fault {

/// One direction of a wire under faults: first the damage to messages, then the delay.
template <class Carried>
class FaultyWire {
 public:
  FaultyWire(std::uint64_t seed, const std::string& device, wire::LineRate rate = {},
             FrameChecksums checksums = {})
      : faults_(seed, device, rate, std::move(checksums)), held_(seed, device) {}

  void set(const std::vector<InForce>& faults) {
    faults_.set(faults);
    held_.set(faults);
  }
  void put(Carried message, Stamp now, std::optional<Stamp> sampled_at = {}) {
    faults_.pass(std::move(message), [&](const Carried& out) { held_.put(out, now, sampled_at); });
  }
  /// Bytes between messages keep their place and get the same delay.
  void put_between(Carried noise, Stamp now) {
    faults_.pass_between(std::move(noise),
                         [&](const Carried& out) { held_.put(out, now, {}, false); });
  }
  /// Releases a message that waits for its successor.
  void release(Stamp now) {
    faults_.release([&](const Carried& out) { held_.put(out, now, {}, false); });
  }
  std::optional<Stamp> deadline() const { return held_.deadline(); }
  std::optional<Carried> take(Stamp now) { return held_.take(now); }
  std::optional<Stamp> sampled_at() const { return held_.sampled_at(); }
  bool silent() const { return faults_.silent(); }
  bool empty() const { return held_.empty(); }               ///< no message is on its way
  bool idle() const { return empty() && !faults_.holds(); }  ///< nor waits for its successor
  void drop_all() {
    faults_.release([](const Carried&) {});
    held_.drop_all();
  }
  FaultHits hits() const {
    FaultHits all = faults_.hits();
    all += held_.hits();
    return all;
  }

 private:
  MessageFaults<Carried> faults_;
  HeldMessages<Carried> held_;
};

}  // namespace drydock::fault
