#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "hil/fault/wire/damage.hpp"

namespace drydock::fault {

/// What a wire does to the messages that go over it, one after the other: they come through sound,
/// damaged, twice, later than their successor or not at all. `Carried` is Message or CanFrame.
template <class Carried>
class MessageFaults {
 public:
  using Emit = std::function<void(const Carried&)>;

  /// Random numbers follow from seed, device and kind of fault. `baud`: of the receiver; 0: none.
  MessageFaults(std::uint64_t seed, std::string device, double baud = 0)
      : seed_(seed), device_(std::move(device)), baud_(baud) {}

  /// From now on these are in force.
  void set(const std::vector<InForce>& faults);

  void pass(Carried message, const Emit& emit);
  /// What is no message of the device's: only what the whole line suffers happens to it.
  void pass_between(Carried noise, const Emit& emit);
  /// Nothing waits for its successor any more.
  void release(const Emit& emit);

  const FaultHits& hits() const { return hits_; }
  bool silent() const { return silent_; }  ///< nothing comes through

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
  double baud_;
  std::vector<Active> active_;
  std::optional<Carried> held_;  ///< until its successor has gone
  FaultHits hits_;
  bool silent_ = false;
};

extern template class MessageFaults<Message>;
extern template class MessageFaults<wire::CanFrame>;

}  // namespace drydock::fault
