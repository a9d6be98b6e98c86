#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/wire/j1939/j1939.hpp"

/// The transport protocol of SAE J1939-21 (ISO 11783-3, NMEA 2000 "ISO TP"). It carries messages of
/// 9 to 1785 bytes in numbered packets of 7. They are sent by broadcast (BAM) or to one node, which
/// grants packets at its own pace. This file has the common part of both ends;
/// j1939_transport_receiver.hpp and ..._sender.hpp have the ends.
namespace drydock::wire::j1939 {

constexpr std::uint32_t transport_control_pgn = 60416;  ///< TP.CM
constexpr std::uint32_t transport_data_pgn = 60160;     ///< TP.DT
constexpr std::size_t transport_packet_bytes = 7;
constexpr std::size_t transport_min_bytes = 9, transport_max_bytes = 1785;

/// J1939-21 section 5.10.3.5. A session that waits longer is closed.
namespace transport_timeout {
using std::chrono::milliseconds;
constexpr milliseconds next_packet{750};    ///< T1, at the receiver
constexpr milliseconds first_packet{1250};  ///< T2, at the receiver, after clear to send
constexpr milliseconds answer{1250};        ///< T3, at the sender, after its last packet
constexpr milliseconds held{1050};          ///< T4, at the sender, after it was told to wait
constexpr milliseconds broadcast_gap{50};   ///< minimum time between packets of a broadcast
}  // namespace transport_timeout

/// TP.CM. The kind determines which numbers are used.
struct TransportControl {
  enum class Kind : std::uint8_t {
    request_to_send = 16,  ///< size, packets, limit
    clear_to_send = 17,    ///< packets that may come now (0: wait), starting with `next`
    end_of_message = 19,   ///< size, packets
    broadcast = 32,        ///< size, packets
    abort = 255,           ///< reason
  };
  enum Reason : std::uint8_t {
    already_connected = 1,
    timed_out = 3,
    unexpected_clear_to_send = 4,
    too_many_repeats = 5,
    bad_sequence = 7,
    too_long = 9,
  };
  Kind kind = Kind::abort;
  std::uint8_t source = null_address, destination = global_address;
  std::uint32_t pgn = 0;  ///< PGN of the transported message
  std::uint16_t size = 0;
  std::uint8_t packets = 0;
  std::uint8_t limit = 0xFF;  ///< packets for one clear-to-send; 255: no limit
  std::uint8_t next = 1;
  std::uint8_t reason = 0;
};

/// Empty for a frame of another PGN, a truncated frame, or an unknown kind.
std::optional<TransportControl> decode_transport_control(const Identifier& id, Bytes payload);
CanFrame encode(const TransportControl& control);

constexpr unsigned transport_packets(std::size_t size) {
  return static_cast<unsigned>((size + transport_packet_bytes - 1) / transport_packet_bytes);
}

/// TP.DT: packet `number` (from 1) of a message; unused bytes are 0xFF.
CanFrame encode_transport_packet(std::uint8_t source, std::uint8_t destination, Bytes message,
                                 unsigned number);

}  // namespace drydock::wire::j1939
