#pragma once

#include "drivers/wire/j1939/aceinna.hpp"

/// MicroStrain (Parker LORD) MV5-AR inertial sensor on J1939. Sources: the DBC and the driver of a
/// public repository (psaucedoa/microstrain_mv5_can_driver), the MV5-AR manual. The fields stand
/// where Aceinna's stand. But the first is about or along the lateral axis, as SAE J1939-71 says,
/// and the second the longitudinal one: Aceinna calls them X and Y.
namespace drydock::wire::mv5 {

/// SAE's manufacturer code in the device's NAME.
constexpr std::uint16_t manufacturer = 569;
constexpr std::uint8_t default_address = 0xE2;

using aceinna::FigureOfMerit;
using aceinna::SlopeSensor;

/// PGN 61482. Place 0: pitch rate, about the lateral axis; 1: roll rate, about the longitudinal
/// axis; 2: yaw rate.
struct AngularRate : aceinna::AngularRate {
  static constexpr std::string_view type = "sae_angular_rate";
};

/// PGN 61485. Place 0: lateral; 1: longitudinal; 2: vertical. Gravity is included.
struct Acceleration : aceinna::Acceleration {
  static constexpr std::string_view type = "sae_acceleration";
};

template <class Field>
void visit_fields(const AngularRate& m, Field&& field) {
  field("source", m.source);
  field("pitch_rate_degps", degrees(m.rate_radps[0]));
  field("roll_rate_degps", degrees(m.rate_radps[1]));
  field("yaw_rate_degps", degrees(m.rate_radps[2]));
  field("pitch_rate_merit", to_string(m.merit[0]));
  field("roll_rate_merit", to_string(m.merit[1]));
  field("yaw_rate_merit", to_string(m.merit[2]));
  field("latency_s", m.latency_s);
}

template <class Field>
void visit_fields(const Acceleration& m, Field&& field) {
  field("source", m.source);
  field("lateral_mps2", m.acceleration_mps2[0]);
  field("longitudinal_mps2", m.acceleration_mps2[1]);
  field("vertical_mps2", m.acceleration_mps2[2]);
  field("lateral_merit", to_string(m.merit[0]));
  field("longitudinal_merit", to_string(m.merit[1]));
  field("vertical_merit", to_string(m.merit[2]));
}

}  // namespace drydock::wire::mv5

namespace drydock::wire {

struct Mv5 {
  static constexpr std::string_view name = "microstrain-mv5";
  using Message =
      std::variant<mv5::SlopeSensor, mv5::AngularRate, mv5::Acceleration, j1939::AddressClaimed>;

  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    Aceinna::Decoder fields_;
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
