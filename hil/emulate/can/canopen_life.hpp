#pragma once

#include <utility>

#include "drivers/measurement/earlier.hpp"
#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/can/canopen_settings.hpp"

namespace drydock::emulate {

/// Whether the master of a node still lives: by its heartbeat (1016h), from the first one on, and
/// by its guarding (100Ch, 100Dh), from its first question on.
class CanopenLife {
 public:
  using Stamp = measurement::Stamp;

  /// True: a master that was lost is there again.
  bool hear_heartbeat(const CanopenSettings& settings, Stamp now) {
    heartbeat_due_.reset();
    if (settings.patience().count() > 0) heartbeat_due_ = now + settings.patience();
    return std::exchange(lost_, false);
  }
  bool hear_guarding(const CanopenSettings& settings, Stamp now) {
    guarding_due_.reset();
    if (settings.life().count() > 0) guarding_due_ = now + settings.life();
    return std::exchange(lost_, false);
  }
  /// The bit of the answer to guarding.
  bool next_toggle() { return std::exchange(toggle_, !toggle_); }

  void restart() { *this = {}; }
  /// 1016h was written: it watches from the next heartbeat on.
  void forget_heartbeat() { heartbeat_due_.reset(); }

  std::optional<Stamp> deadline() const {
    return measurement::earlier(heartbeat_due_, guarding_due_);
  }
  /// True once for a master that has fallen silent.
  bool is_lost(Stamp now) {
    const auto due = deadline();
    if (!due || *due > now) return false;
    heartbeat_due_.reset();
    guarding_due_.reset();
    lost_ = true;
    return true;
  }

 private:
  std::optional<Stamp> heartbeat_due_, guarding_due_;
  bool toggle_ = false, lost_ = false;
};

}  // namespace drydock::emulate
