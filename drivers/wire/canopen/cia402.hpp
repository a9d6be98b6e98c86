#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/canopen/cia402_states.hpp"
#include "drivers/wire/codec.hpp"

/// Electric drives that follow CiA 402, with the process data of its mode "position" or "velocity":
/// RPDO1 is the control word and a target, TPDO1 the status word and the actual value, both
/// INTEGER32. docs/sensors/protocols/cia402.md has the objects.
namespace drydock::wire::cia402 {

/// COB-ID of receive PDO 1 of a node, predefined connection set.
constexpr std::uint32_t rpdo1_base = 0x200;

/// Objects 6060h and 6061h.
enum class Mode : std::uint8_t { profile_velocity = 3, cyclic_position = 8 };

/// Objects of CiA 301 and 402 that a master sets or reads.
constexpr std::uint16_t consumer_heartbeat_index = 0x1016, control_word_index = 0x6040,
                        status_word_index = 0x6041, mode_index = 0x6060, mode_shown_index = 0x6061,
                        position_index = 0x6064, velocity_index = 0x606C,
                        target_position_index = 0x607A, encoder_index = 0x608F,
                        target_velocity_index = 0x60FF, supported_modes_index = 0x6502;

/// Increments of the encoder in one turn of the output shaft (object 608Fh): a position is in
/// increments, a velocity in increments a second.
constexpr std::uint32_t increments_per_turn = 65536;
constexpr double radians_per_increment = 2 * std::numbers::pi / increments_per_turn;

/// Rounds, and stays within INTEGER32.
std::int32_t increments_of(double radians);

/// TPDO1.
struct DriveStatus {
  static constexpr std::string_view type = "drive_status";
  std::uint8_t node = 0;
  std::uint16_t status_word = 0;
  std::int32_t actual = 0;  ///< increments, or increments a second
};

/// RPDO1.
struct DriveOrder {
  static constexpr std::string_view type = "drive_order";
  std::uint8_t node = 0;
  std::uint16_t control_word = 0;
  std::int32_t target = 0;  ///< increments, or increments a second
};

std::optional<DriveStatus> decode_status(const CanFrame& frame);
std::optional<DriveOrder> decode_order(const CanFrame& frame);
CanFrame encode(const DriveStatus& message);
CanFrame encode(const DriveOrder& message);

template <class Field>
void visit_fields(const DriveStatus& m, Field&& field) {
  const auto state = state_of(m.status_word);
  field("node", m.node);
  field("status_word", m.status_word);
  field("state", state ? to_string(*state) : std::string_view("unknown"));
  field("actual", m.actual);
}

template <class Field>
void visit_fields(const DriveOrder& m, Field&& field) {
  field("node", m.node);
  field("control_word", m.control_word);
  field("target", m.target);
}

}  // namespace drydock::wire::cia402

namespace drydock::wire {

struct Cia402 {
  static constexpr std::string_view name = "cia402";
  using Message =
      std::variant<cia402::DriveStatus, cia402::DriveOrder, canopen::Heartbeat, canopen::Emergency>;

  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
