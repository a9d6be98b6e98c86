#pragma once

#include <array>
#include <optional>

#include "drivers/capture/record.hpp"
#include "drivers/wire/j1939/j1939_transport.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"

namespace drydock::capture {

/// A message of NMEA 2000 as a line has it: whole, or the data of one frame.
struct N2kMessage {
  std::optional<std::chrono::nanoseconds> time;
  wire::j1939::Identifier id;
  std::array<std::uint8_t, wire::j1939::transport_max_bytes> data{};
  std::size_t size = 0;
};

/// The frames that a message came in, all with one time: one, those of a fast packet again, or
/// those of J1939's transport protocol.
class MessageFrames {
 public:
  /// The first frame. `is_whole`: the line has the message, however short it is; else one of up to
  /// 8 bytes is a frame. Of more than 8 bytes under a PGN that is one frame it gives the first 8,
  /// and damage: no bus carried the rest.
  Reading first(const N2kMessage& message, bool is_whole);
  std::optional<Record> more();

 private:
  enum class Way : std::uint8_t { one_frame, fast_packet, transport };

  Way way_of(bool is_whole) const;
  std::size_t frames() const;
  wire::CanFrame frame(std::size_t number) const;

  N2kMessage message_;
  Way way_ = Way::one_frame;
  std::size_t given_ = 0;
  std::uint8_t sequence_ = 0;
};

}  // namespace drydock::capture
