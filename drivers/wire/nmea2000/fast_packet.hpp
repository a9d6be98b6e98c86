#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/j1939/packet_numbers.hpp"

/// NMEA 2000 fast packet: up to 223 bytes in at most 32 frames. Byte 0 is sequence<<5 | index.
/// Frame 0 carries the length and 6 bytes, each further frame 7 bytes.
namespace drydock::wire {

constexpr std::size_t fast_packet_max_bytes = 223;

/// One complete message. `data` points into the assembler and is valid until its next call.
struct FastPacket {
  j1939::Identifier id;
  std::span<const std::uint8_t> data;
};

/// Assembles messages by (PGN, source, sequence). Frames of one message must come in order, and
/// within 750 ms of each other: a lost, late or misplaced frame drops the message. A frame that
/// comes twice in a row is taken once. Any other frame 0 starts a new message, so it is never
/// joined to an earlier one.
class FastPacketAssembler {
 public:
  using Time = std::chrono::nanoseconds;

  static constexpr std::size_t max_concurrent = 16;  ///< then drops the longest idle message
  static constexpr std::chrono::milliseconds next_frame{750};  ///< a message waits no longer for it

  struct Counters {
    std::uint64_t messages = 0;
    std::uint64_t dropped = 0;   ///< messages that began but were never completed
    std::uint64_t headless = 0;  ///< messages whose first frame did not come, or was damaged
    std::uint64_t stray = 0;     ///< frames without a message or too short; invalid lengths
  };

  /// A listener without a clock leaves `now` out; then only the numbers show a lost frame.
  std::optional<FastPacket> receive(const j1939::Identifier& id, Bytes payload, Time now = {});
  void expire(Time now);  ///< drops the messages whose next frame did not come in time
  const Counters& counters() const { return counters_; }
  std::uint64_t unfinished() const;  ///< messages that have begun and wait for frames

 private:
  /// The last message of a node that ended, or is lost.
  struct Behind {
    std::uint32_t pgn = 0;
    std::uint8_t source = 0, sequence = 0;
    j1939::PacketNumbers heard;
    bool known = false;
  };
  struct Assembly {
    bool busy = false;
    std::uint32_t pgn = 0;
    std::uint8_t source = 0;
    std::uint8_t sequence = 0;
    std::uint8_t next_index = 0;
    std::uint8_t total = 0;
    std::uint8_t held = 0;
    j1939::PacketNumbers heard;
    Time heard_at{};
    std::uint64_t last_used = 0;
    std::array<std::uint8_t, fast_packet_max_bytes> data{};
  };

  static bool is_again(const Assembly& assembly, std::uint8_t index, Bytes payload);

  Assembly* find(const j1939::Identifier& id, std::uint8_t sequence);
  Assembly& free_slot();
  std::optional<FastPacket> begin(const j1939::Identifier& id, std::uint8_t sequence, Bytes payload,
                                  Time now);
  std::optional<FastPacket> append(Assembly& assembly, const j1939::Identifier& id, Bytes data,
                                   std::size_t room);
  void drop(Assembly& assembly);
  void note_stray(const j1939::Identifier& id, std::uint8_t sequence, std::uint8_t index);
  Behind* behind(std::uint32_t pgn, std::uint8_t source);
  void remember(const Assembly& assembly);

  std::array<Assembly, max_concurrent> assemblies_{};
  std::array<Behind, max_concurrent> behind_{};
  std::size_t next_behind_ = 0;
  std::uint64_t clock_ = 0;
  Counters counters_;
};

/// True for the first frame of a message: its index is 0.
constexpr bool begins_fast_packet(Bytes payload) {
  return !payload.empty() && (payload[0] & 0x1F) == 0;
}

/// Number of frames for a message of `size` bytes.
constexpr std::size_t fast_packet_frames(std::size_t size) { return 1 + size / 7; }

/// Frame `index` of a message of at most 223 bytes; unused bytes are 0xFF.
CanFrame encode_fast_packet(const j1939::Identifier& id, std::uint8_t sequence, Bytes message,
                            std::size_t index);

}  // namespace drydock::wire
