#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::device {

/// Asks the nodes of a bus for their NAMEs (PGN 59904 for 60928, SAE J1939-81). It asks when the
/// bus opens, and every 10 s while our sensor is silent: the sensor may have claimed another
/// address while nobody listened. Behind a long silence it asks after a tenth of that, so a pause
/// of years in a trace is crossed in few steps. It asks from the null address, as a node without an
/// address may.
class NodeSearch {
 public:
  static constexpr std::chrono::seconds patience{10};

  void restart(Stamp now, Output& out) {
    silent_since_ = now;
    ask(now, out);
  }
  void heard(Stamp now) {
    silent_since_ = now;
    next_ = now + patience;
  }
  void tick(Stamp now, Output& out) {
    if (next_ && *next_ <= now) ask(now, out);
  }
  std::optional<Stamp> deadline() const { return next_; }

 private:
  void ask(Stamp now, Output& out) {
    out.send(encode(wire::j1939::Request{.pgn = wire::j1939::address_claim_pgn}));
    next_ = now + std::max<Stamp::duration>(patience, (now - silent_since_) / 10);
  }

  Stamp silent_since_{};
  std::optional<Stamp> next_;  ///< empty: the bus has not been open yet
};

}  // namespace drydock::device
