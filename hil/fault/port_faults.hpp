#pragma once

#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

/// Faults of the drivers' port: it is gone, or it hangs up once and can be opened again.
class PortFaults {
 public:
  /// `set_port(there)` is called for each change.
  template <class SetPort>
  void set(const std::vector<InForce>& faults, SetPort&& set_port) {
    const bool unplugged = find(faults, FaultKind::unplug) != nullptr;
    if (unplugged != unplugged_) set_port(!unplugged);
    hits_[FaultKind::unplug] += unplugged && !unplugged_;
    unplugged_ = unplugged;
    const InForce* eof = find(faults, FaultKind::eof);
    if (!eof || eof->since == hung_up_) return;
    hung_up_ = eof->since;
    ++hits_[FaultKind::eof];
    if (unplugged_) return;  // a missing port has hung up already
    set_port(false);
    set_port(true);
  }
  bool unplugged() const { return unplugged_; }
  const FaultHits& hits() const { return hits_; }

 private:
  std::optional<Stamp> hung_up_;  ///< start of the last "eof" that was carried out
  bool unplugged_ = false;
  FaultHits hits_;
};

}  // namespace drydock::fault
