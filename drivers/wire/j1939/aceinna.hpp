#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"
#include "drivers/wire/j1939/aceinna_setup.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// Aceinna MTLT305D / OpenIMU300RI inertial sensors on J1939. Layouts: the vendor's DBC 19.1.51 and
/// DMU380 manual. These messages keep the axes of the wire.
///
/// A trap: names differ for the axes. The DBC calls them X, Y, Z. SAE J1939-71 calls the same
/// fields pitch rate about the lateral axis, roll rate, yaw rate, and lateral, longitudinal,
/// vertical acceleration. The orientation of the device is a setting, and the vendor's own script
/// uses x = Y, y = -X, z = -Z to get NED. That is a reflection, and no mounting rotation can undo
/// it. A driver that needs it must offer it as a separate option, before the mounting.
namespace drydock::wire::aceinna {

// Of SAE J1939-71; other makers' sensors send them too.
constexpr std::uint32_t slope_pgn = 61481;
constexpr std::uint32_t rate_pgn = 61482;
constexpr std::uint32_t acceleration_pgn = 61485;

/// How far the device trusts a value. Values marked error or not_available are empty.
enum class FigureOfMerit : std::uint8_t { ok, degraded, error, not_available };

constexpr std::string_view to_string(FigureOfMerit merit) {
  constexpr std::array<std::string_view, 4> names{"ok", "degraded", "error", "not_available"};
  return names[static_cast<std::size_t>(merit)];
}

/// SSI2, PGN 61481: attitude from the device's own filter.
struct SlopeSensor {
  static constexpr std::string_view type = "slope_sensor";
  std::uint8_t source = j1939::null_address;
  std::optional<double> pitch_rad, roll_rad;
  FigureOfMerit pitch_merit = FigureOfMerit::ok, roll_merit = FigureOfMerit::ok;
  std::uint8_t pitch_compensation = 0, roll_compensation = 0;  ///< 2 bits: 0 on, 1 off, 3 n/a
  std::optional<double> latency_s;  ///< from the measurement to the frame
};

/// ARI, PGN 61482: angular rate about the wire's X, Y, Z.
struct AngularRate {
  static constexpr std::string_view type = "angular_rate";
  std::uint8_t source = j1939::null_address;
  std::array<std::optional<double>, 3> rate_radps;
  std::array<FigureOfMerit, 3> merit{};
  std::optional<double> latency_s;
};

/// ACCS, PGN 61485: acceleration along the wire's X, Y, Z, gravity included.
struct Acceleration {
  static constexpr std::string_view type = "acceleration";
  std::uint8_t source = j1939::null_address;
  std::array<std::optional<double>, 3> acceleration_mps2;
  std::array<FigureOfMerit, 3> merit{};
  std::uint8_t rate_support = 3;  ///< 2 bits: variable transmission rate, 3 n/a
};

/// PGN 65386: magnetic field along the wire's X, Y, Z.
struct MagneticField {
  static constexpr std::string_view type = "magnetic_field";
  std::uint8_t source = j1939::null_address;
  std::array<std::optional<double>, 3> field_t;  ///< tesla
};

/// PGN 60928 as Aceinna encodes it: the fields of the NAME are in reverse order.
struct AddressClaimed {
  static constexpr std::string_view type = "address_claimed";
  std::uint8_t source = j1939::null_address;
  j1939::Name name;
};

CanFrame encode(const SlopeSensor& message);
CanFrame encode(const AngularRate& message);
CanFrame encode(const Acceleration& message);
CanFrame encode(const MagneticField& message);
CanFrame encode(const AddressClaimed& message);

/// The number that is compared in contention on the bus, in Aceinna's field order.
std::uint64_t to_value(const j1939::Name& name);
j1939::Name to_name(std::uint64_t value);

template <class Field>
void visit_fields(const SlopeSensor& m, Field&& field) {
  field("source", m.source);
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("pitch_merit", to_string(m.pitch_merit));
  field("roll_merit", to_string(m.roll_merit));
  field("pitch_compensation", m.pitch_compensation);
  field("roll_compensation", m.roll_compensation);
  field("latency_s", m.latency_s);
}

template <class Field>
void visit_fields(const AngularRate& m, Field&& field) {
  field("source", m.source);
  field("rate_x_degps", degrees(m.rate_radps[0]));
  field("rate_y_degps", degrees(m.rate_radps[1]));
  field("rate_z_degps", degrees(m.rate_radps[2]));
  field("merit_x", to_string(m.merit[0]));
  field("merit_y", to_string(m.merit[1]));
  field("merit_z", to_string(m.merit[2]));
  field("latency_s", m.latency_s);
}

template <class Field>
void visit_fields(const Acceleration& m, Field&& field) {
  field("source", m.source);
  field("acceleration_x_mps2", m.acceleration_mps2[0]);
  field("acceleration_y_mps2", m.acceleration_mps2[1]);
  field("acceleration_z_mps2", m.acceleration_mps2[2]);
  field("merit_x", to_string(m.merit[0]));
  field("merit_y", to_string(m.merit[1]));
  field("merit_z", to_string(m.merit[2]));
  field("rate_support", m.rate_support);
}

template <class Field>
void visit_fields(const MagneticField& m, Field&& field) {
  field("source", m.source);
  field("magnetic_x_t", m.field_t[0]);
  field("magnetic_y_t", m.field_t[1]);
  field("magnetic_z_t", m.field_t[2]);
}

template <class Field>
void visit_fields(const AddressClaimed& m, Field&& field) {
  field("source", m.source);
  j1939::visit_fields(m.name, field);
}

}  // namespace drydock::wire::aceinna

namespace drydock::wire {

struct Aceinna {
  static constexpr std::string_view name = "aceinna";
  using Message = std::variant<aceinna::SlopeSensor, aceinna::AngularRate, aceinna::Acceleration,
                               aceinna::MagneticField, aceinna::AddressClaimed,
                               aceinna::HardwareBit, aceinna::SoftwareBit, aceinna::SensorStatus,
                               aceinna::PacketRate, aceinna::PacketType, aceinna::DigitalFilter,
                               aceinna::Orientation, j1939::Request>;

  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
