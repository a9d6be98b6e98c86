#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/dvl_frame.hpp"
#include "drivers/wire/fields.hpp"

/// Teledyne Wayfinder: AA 10 01, length, an application part with an id of its own, sum of all
/// bytes modulo 65536; little-endian. Source: the maker's example programs
/// (Teledyne-Marine/Wayfinder).
namespace drydock::wire {

/// The data of a ping. Whether the vehicle or the bed moves with these velocities stands in no
/// public document (docs/sensors/protocols/wayfinder.md).
struct WayfinderPing {
  static constexpr std::string_view type = "wayfinder_ping";
  unsigned version = 0;  ///< of the structure: 0x10 or 0x11
  unsigned system_type = 0, system_subtype = 0;
  std::array<unsigned, 4> firmware{};
  std::optional<std::chrono::milliseconds> clock;  ///< the DVL's, since 1970, of the ping
  std::optional<DvlFrame> frame;                   ///< of the velocities; empty: not known
  DvlComponents velocity_mps;                      ///< X, Y, Z, error, or beams 1 to 4
  std::array<std::optional<double>, 4> range_m;    ///< to the bottom, of each beam
  std::optional<double> mean_range_m, sound_speed_mps;
  unsigned status = 0, test_count = 0, test_code = 0;  ///< bits and codes, as sent
  std::optional<double> input_v, transmit_v, current_a;
};

/// The answer to a command with the same number.
struct WayfinderAnswer {
  static constexpr std::string_view type = "wayfinder_answer";
  unsigned command = 0;
  unsigned status = 0;  ///< 1 done, 2 unknown, 3 parameter, 4 execution, 5 set, 6 get, 7 it pings
};

/// A sound packet of another kind, under the id of its application part.
struct WayfinderOther {
  static constexpr std::string_view type = "wayfinder_other";
  unsigned id = 0, payload_bytes = 0;
};

/// What a sound packet carries.
struct WayfinderPart {
  unsigned id = 0;  ///< of the kinds of packets, as wayfinder::Ids
  Bytes payload;    ///< within the packet
};

namespace wayfinder {

enum Ids : std::uint8_t { command_id = 3, answer_id = 4, data_id = 5 };

inline constexpr double beam_angle_rad = 0.5235987755982988;  ///< 30 degrees
inline constexpr std::size_t ping_packet_size = 98;           ///< of version 0x10

/// The application part of a sound packet.
WayfinderPart part_of(Bytes packet);

/// A whole packet around a payload; its size. `out` has room for 11 bytes more than the payload.
std::size_t encode_packet(std::uint8_t id, Bytes payload, std::span<std::uint8_t> out);

}  // namespace wayfinder

/// A packet with data of version 0x10; its size, ping_packet_size.
std::size_t encode(const WayfinderPing& m, std::span<std::uint8_t> out);

struct Wayfinder {
  static constexpr std::string_view name = "wayfinder";
  static constexpr std::size_t max_frame = 33'000;
  using Message = std::variant<WayfinderPing, WayfinderAnswer, WayfinderOther>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

template <class F>
void visit_fields(const WayfinderPing& m, F&& field) {
  using Name = std::optional<std::string_view>;
  field("version", m.version);
  field("system_type", m.system_type);
  field("system_subtype", m.system_subtype);
  field("firmware", m.firmware);
  field("clock_s", seconds(m.clock));
  field("frame", m.frame ? Name(to_string(*m.frame)) : Name());
  field("velocity_mps", m.velocity_mps);
  field("range_m", m.range_m);
  field("mean_range_m", m.mean_range_m);
  field("sound_speed_mps", m.sound_speed_mps);
  field("status", m.status);
  field("test_count", m.test_count);
  field("test_code", m.test_code);
  field("input_v", m.input_v);
  field("transmit_v", m.transmit_v);
  field("current_a", m.current_a);
}

template <class F>
void visit_fields(const WayfinderAnswer& m, F&& field) {
  field("command", m.command);
  field("status", m.status);
}

template <class F>
void visit_fields(const WayfinderOther& m, F&& field) {
  field("id", m.id);
  field("payload_bytes", m.payload_bytes);
}

}  // namespace drydock::wire
