#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// Settings and status reports of an Aceinna IMU, PGNs FF52h to FF58h (vendor's DBC 19.1.51). A
/// setting is sent as [address of the device, value]. The device answers a request (PGN 59904) for
/// the same PGN with the setting in force.
namespace drydock::wire::aceinna {

constexpr std::uint32_t hardware_bit_pgn = 0xFF52, software_bit_pgn = 0xFF53, status_pgn = 0xFF54;
constexpr std::uint32_t packet_rate_pgn = 0xFF55, packet_type_pgn = 0xFF56, filter_pgn = 0xFF57,
                        orientation_pgn = 0xFF58;

/// One bit of a status message. Without words it is a normal state, not an error.
struct Flag {
  unsigned bit;
  std::string_view key, words;
};

/// A status message of at most 16 flags.
template <class Layout>
struct Flags {
  static constexpr std::string_view type = Layout::type;
  std::uint8_t source = j1939::null_address;
  std::uint16_t bits = 0;

  bool has(const Flag& flag) const { return (bits >> flag.bit & 1) != 0; }
  /// The first error flag that is set, in words. Empty if there is none.
  std::string_view trouble() const {
    for (const Flag& flag : Layout::flags) {
      if (has(flag) && !flag.words.empty()) return flag.words;
    }
    return {};
  }
};

struct HardwareLayout {
  static constexpr std::string_view type = "hardware_bit";
  static constexpr std::array<Flag, 4> flags{
      {{2, "rate_error", "internal gyro error"},
       {3, "acceleration_error", "internal accelerometer error"},
       {1, "sensor_error", "internal hardware error"},
       {0, "master_fail", "a fatal error has occurred"}}};
};

struct SoftwareLayout {
  static constexpr std::string_view type = "software_bit";
  static constexpr std::array<Flag, 6> flags{
      {{5, "calibration_error", "incorrect checksum of the calibration"},
       {4, "over_range", "sensor over range, the algorithm needs a reset"},
       {3, "initialization_error", "internal software error at initialization"},
       {2, "data_error", "data error"},
       {1, "algorithm_error", "algorithm error"},
       {0, "software_error", "internal software error"}}};
};

struct StatusLayout {
  static constexpr std::string_view type = "sensor_status";
  static constexpr std::array<Flag, 9> flags{{{12, "sensor_over_range", "sensor over range"},
                                              {3, "sensor_status", "sensor fault"},
                                              {2, "software_status", "software fault"},
                                              {1, "hardware_status", "hardware fault"},
                                              {0, "master_status", "fault"},
                                              {7, "eeprom_unlocked", {}},
                                              {8, "algorithm_initializing", {}},
                                              {10, "attitude_only", {}},
                                              {11, "turn_switch", {}}}};
};

using HardwareBit = Flags<HardwareLayout>;
using SoftwareBit = Flags<SoftwareLayout>;
using SensorStatus = Flags<StatusLayout>;

/// Messages come at 100 Hz / divider; 0: none.
struct PacketRate {
  static constexpr std::string_view type = "packet_rate";
  static constexpr std::uint32_t pgn = packet_rate_pgn;
  static constexpr std::array<std::uint8_t, 9> dividers{0, 1, 2, 4, 5, 10, 20, 25, 50};
  std::uint8_t source = j1939::null_address, device = j1939::null_address;
  std::uint8_t divider = 1;
};

struct PacketType {
  static constexpr std::string_view type = "packet_type";
  static constexpr std::uint32_t pgn = packet_type_pgn;
  static constexpr std::uint8_t slope = 1, rate = 2, acceleration = 4;
  std::uint8_t source = j1939::null_address, device = j1939::null_address;
  std::uint8_t packets = slope | rate | acceleration;
};

/// Cut-off frequencies of the low-pass filters: 0 (off), 2, 5, 10, 20, 25, 40, 50 Hz.
struct DigitalFilter {
  static constexpr std::string_view type = "digital_filter";
  static constexpr std::uint32_t pgn = filter_pgn;
  std::uint8_t source = j1939::null_address, device = j1939::null_address;
  std::uint8_t rate_hz = 25, acceleration_hz = 25;
};

/// The axes of the housing that are reported as X, Y, Z; see Axes.
struct Orientation {
  static constexpr std::string_view type = "orientation";
  static constexpr std::uint32_t pgn = orientation_pgn;
  std::uint8_t source = j1939::null_address, device = j1939::null_address;
  std::uint16_t code = 0;
};

/// The axes of the housing for the output X, Y, Z.
struct Axes {
  struct Axis {
    std::uint8_t index = 0;  ///< axis of the housing: 0 X, 1 Y, 2 Z
    bool negative = false;
    friend bool operator==(const Axis&, const Axis&) = default;
  };
  std::array<Axis, 3> output{{{0, false}, {1, false}, {2, false}}};

  bool right_handed() const;
  std::uint16_t code() const;
  /// Empty if the code is not one of the 24 right-handed orientations.
  static std::optional<Axes> of_code(std::uint16_t code);
  /// Parses "+X+Y+Z" and the like. Empty for other text and left-handed orientations.
  static std::optional<Axes> of_text(std::string_view text);
};

CanFrame encode(const HardwareBit& message);
CanFrame encode(const SoftwareBit& message);
CanFrame encode(const SensorStatus& message);
CanFrame encode(const PacketRate& message);
CanFrame encode(const PacketType& message);
CanFrame encode(const DigitalFilter& message);
CanFrame encode(const Orientation& message);

// False if the payload is too short.
bool read(std::uint8_t source, Bytes payload, HardwareBit& message);
bool read(std::uint8_t source, Bytes payload, SoftwareBit& message);
bool read(std::uint8_t source, Bytes payload, SensorStatus& message);
bool read(std::uint8_t source, Bytes payload, PacketRate& message);
bool read(std::uint8_t source, Bytes payload, PacketType& message);
bool read(std::uint8_t source, Bytes payload, DigitalFilter& message);
bool read(std::uint8_t source, Bytes payload, Orientation& message);

template <class Layout, class Field>
void visit_fields(const Flags<Layout>& m, Field&& field) {
  field("source", m.source);
  for (const Flag& flag : Layout::flags) field(flag.key, m.has(flag));
}

template <class Field>
void visit_fields(const PacketRate& m, Field&& field) {
  field("source", m.source);
  field("device", m.device);
  field("divider", m.divider);
}

template <class Field>
void visit_fields(const PacketType& m, Field&& field) {
  field("source", m.source);
  field("device", m.device);
  field("slope", (m.packets & PacketType::slope) != 0);
  field("rate", (m.packets & PacketType::rate) != 0);
  field("acceleration", (m.packets & PacketType::acceleration) != 0);
}

template <class Field>
void visit_fields(const DigitalFilter& m, Field&& field) {
  field("source", m.source);
  field("device", m.device);
  field("rate_cut_off_hz", m.rate_hz);
  field("acceleration_cut_off_hz", m.acceleration_hz);
}

template <class Field>
void visit_fields(const Orientation& m, Field&& field) {
  field("source", m.source);
  field("device", m.device);
  field("code", m.code);
}

}  // namespace drydock::wire::aceinna
