#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drivers/wire/bytes.hpp"

/// Messages CFG-* that a receiver takes and tells again, and that change nothing here: information
/// messages, antenna supervisor, NMEA, odometer, navigation expert settings, time pulse,
/// interference monitor. They are as delivered after a restart; CFG-CFG does not save them.
/// Sources: as ublox_items.hpp.
namespace drydock::emulate::ublox {

struct KeptMessage {
  std::uint16_t id;
  std::size_t size;
  bool selects;  ///< the first byte of the payload says which of several: a protocol, a time pulse
  std::array<std::uint8_t, 40> payload;
};

class KeptMessages {
 public:
  KeptMessages() { restart(); }
  void restart();

  bool has(std::uint16_t id) const;
  /// What answers a poll. Empty: the payload is no poll.
  wire::Bytes polled(std::uint16_t id, wire::Bytes payload) const;
  /// False: the payload is no setting, and nothing has changed.
  bool take(std::uint16_t id, wire::Bytes payload);

 private:
  std::vector<KeptMessage> messages_;
};

}  // namespace drydock::emulate::ublox
