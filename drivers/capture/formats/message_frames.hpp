#pragma once

#include <array>
#include <optional>

#include "drivers/capture/record.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"

namespace drydock::capture {

/// A message of NMEA 2000 as a line has it: whole, or the data of one frame.
struct N2kMessage {
  std::optional<std::chrono::nanoseconds> time;
  wire::j1939::Identifier id;
  std::array<std::uint8_t, wire::fast_packet_max_bytes> data{};
  std::size_t size = 0;
};

/// The frames that a message came in: one, or those of a fast packet again, all with one time.
class MessageFrames {
 public:
  Record first(const N2kMessage& message, bool is_fast);
  std::optional<Record> more();

 private:
  Record next();

  N2kMessage message_;
  std::size_t given_ = 0;
  std::uint8_t sequence_ = 0;
  bool is_fast_ = false;
};

}  // namespace drydock::capture
