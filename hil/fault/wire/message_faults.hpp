#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "hil/fault/wire/damage.hpp"
#include "hil/fault/wire/frame_checksums.hpp"

namespace drydock::fault {

/// Damages messages on a wire, one after the other. A message passes unchanged, damaged, twice,
/// after its successor, or not at all. `Carried` is Message or CanFrame.
template <class Carried>
class MessageFaults {
 public:
  using Emit = std::function<void(const Carried&)>;

  /// Random numbers depend on seed, device and kind of fault. `rate` is the receiver's.
  MessageFaults(std::uint64_t seed, std::string device, wire::LineRate rate = {},
                FrameChecksums checksums = {})
      : seed_(seed), device_(std::move(device)), rate_(rate), checksums_(std::move(checksums)) {}

  /// Sets the faults in force.
  void set(const std::vector<InForce>& faults);

  void pass(Carried message, const Emit& emit);
  /// Bytes that are no message: only faults of the whole line affect them.
  void pass_between(Carried noise, const Emit& emit);
  /// Emits a message that still waits for its successor.
  void release(const Emit& emit);

  const FaultHits& hits() const { return hits_; }
  bool silent() const { return silent_; }           ///< no message passes
  bool holds() const { return held_.has_value(); }  ///< a message waits for its successor

 private:
  struct Active {
    FaultConfig fault;
    RandomStream random;
    bool strikes() { return random.uniform() < fault.probability; }
  };

  Active* find(FaultKind kind);
  bool strikes(FaultKind kind);
  void damage(Carried& message);
  void hear_at_wrong_baud(Carried& bytes);

  std::uint64_t seed_;
  std::string device_;
  wire::LineRate rate_;
  FrameChecksums checksums_;
  std::vector<Active> active_;
  std::optional<Carried> held_;  ///< waits until its successor has gone
  FaultHits hits_;
  bool silent_ = false;
};

extern template class MessageFaults<Message>;
extern template class MessageFaults<wire::CanFrame>;

}  // namespace drydock::fault
