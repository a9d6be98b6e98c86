#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/codec.hpp"

/// Pressure transmitters that follow CiA 404. TPDO1 begins with the process value, as INTEGER32
/// (9130h, WIKA 2090h) or as REAL32 (6130h). After it, makers send the status of 6150h, other
/// objects, or nothing. The node's objects give its form and unit, but the frame does not;
/// therefore the rig file gives them. docs/sensors/protocols/cia404-pressure.md lists the makers.
namespace drydock::wire::cia404_pressure {

enum class Form : std::uint8_t {
  integer_and_status,  ///< 5 bytes
  integer,             ///< 4 bytes
  real32,              ///< 4 bytes, or 8 if another object follows
};

/// Bits of object 6150h. 0 means that the value is valid.
namespace status {
constexpr std::uint8_t not_valid = 1, positive_overload = 2, negative_overload = 4;
}

/// TPDO1 with the values of the wire.
struct ProcessValue {
  static constexpr std::string_view type = "process_value";
  std::uint8_t node = 0;
  std::array<std::uint8_t, 4> raw{};
  std::optional<std::uint8_t> status;
};

std::int32_t as_integer(const ProcessValue& value);
std::optional<double> as_real(const ProcessValue& value);  ///< empty: not a finite number

/// A unit in the code of object 6131h (CiA 303-2: decimal prefix, unit) and its size in pascals.
struct Unit {
  std::string_view name;
  std::uint32_t code;
  double pascals;
};
constexpr std::array<Unit, 7> units{{
    {"Pa", 0x00220000, 1},
    {"hPa", 0x02220000, 1e2},
    {"kPa", 0x03220000, 1e3},
    {"MPa", 0x06220000, 1e6},
    {"mbar", 0xFD4E0000, 1e2},
    {"bar", 0x004E0000, 1e5},
    {"psi", 0x00AB0000, 6894.757293168},
}};
const Unit* find_unit(std::string_view name);  ///< null for an unknown name

/// How to read the process value.
struct Scale {
  Form form = Form::integer_and_status;
  Unit unit = units[0];
  unsigned decimals = 0;  ///< object 6132h: decimals of an integer value
};

/// The scale for the names in a rig file: form "integer+status", "integer" or "real32", unit as in
/// `units`. Empty for other names.
std::optional<Scale> find_scale(std::string_view form, std::string_view unit, unsigned decimals);

/// Empty if the status is not valid or the value is no number.
std::optional<double> pressure_pa(const ProcessValue& value, const Scale& scale);

/// TPDO1 of a node. An empty pressure is sent as status "not valid" or as NaN. A pressure that does
/// not fit is sent as an overload.
CanFrame encode(std::uint8_t node, const std::optional<double>& pressure_pa, const Scale& scale);

template <class Field>
void visit_fields(const ProcessValue& m, Field&& field) {
  field("node", m.node);
  field("integer", as_integer(m));
  field("real32", as_real(m));
  field("status", m.status);
}

}  // namespace drydock::wire::cia404_pressure

namespace drydock::wire {

struct Cia404Pressure {
  static constexpr std::string_view name = "cia404-pressure";
  using Message =
      std::variant<cia404_pressure::ProcessValue, canopen::Heartbeat, canopen::Emergency>;

  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
