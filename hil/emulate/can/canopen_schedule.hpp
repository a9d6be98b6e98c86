#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/can/canopen_pdos.hpp"

namespace drydock::emulate {

using measurement::Stamp;

/// Which PDOs a node sends with a sample: those of each n-th SYNC, those whose event timer has run
/// out, or those of each sample. None sooner after its last one than its inhibit time.
class CanopenSchedule {
 public:
  using Chosen = std::array<bool, CanopenPdos::most>;

  /// The node begins to send PDOs, or they have been set up anew: timers begin.
  void begin(const CanopenPdos& pdos, Stamp now);
  void end() { next_.fill({}); }

  std::optional<Stamp> next_event() const;
  Chosen on_sync(const CanopenPdos& pdos);  ///< counts a SYNC
  Chosen at_events(const CanopenPdos& pdos, Stamp at);
  static Chosen at_samples(const CanopenPdos& pdos);
  /// Without those that are off or inhibited; the others count as sent at `at`.
  Chosen sent(const CanopenPdos& pdos, Chosen chosen, Stamp at);

 private:
  std::array<std::uint8_t, CanopenPdos::most> syncs_{};  ///< since it was sent
  std::array<std::optional<Stamp>, CanopenPdos::most> next_{}, sent_at_{};
};

/// Whether any PDO goes with SYNC, and whether any goes with each sample.
bool any_synchronous(const CanopenPdos& pdos);
bool any_at_samples(const CanopenPdos& pdos);

}  // namespace drydock::emulate
