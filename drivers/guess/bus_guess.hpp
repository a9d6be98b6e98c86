#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::guess {

/// A first DBC file of a bus that nobody knows, from the frames that it carried: identifiers,
/// periods, the bits that change, counters and what looks like numbers. It only guesses, and its
/// text says so.
class BusGuess {
 public:
  using Time = std::optional<std::chrono::nanoseconds>;

  void take(const wire::CanFrame& frame, Time time);
  /// Empty: there was no frame with data.
  std::string dbc() const;

 private:
  struct Id {
    std::vector<wire::CanFrame> frames;  ///< the first ones
    std::uint64_t count = 0;
    Time first, last;
    bool fd = false;

    std::optional<double> period_ms() const;
  };
  static std::string message_text(std::uint32_t dbc_id, const Id& id);
  static std::string notes_text(std::uint32_t dbc_id, const Id& id);

  std::map<std::uint32_t, Id> ids_;  ///< by identifier as a DBC file writes it
};

}  // namespace drydock::guess
