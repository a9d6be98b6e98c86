#include "hil/emulate/attitude_readings.hpp"
#include "hil/emulate/can/nmea2000_device.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

constexpr std::array compass_sends{wire::nmea2000::Attitude::pgn,
                                   wire::nmea2000::VesselHeading::pgn,
                                   wire::nmea2000::RateOfTurn::pgn};
// NMEA 2000 class "navigation", function "ownship attitude".
constexpr Nmea2000Product compass{"attitude sensor", 140, 60, 0x27, compass_sends, {}};
constexpr std::uint8_t attitude_sequences = 253;  // SIDs above 252 are reserved

class Nmea2000Attitude final : public Nmea2000Device {
 public:
  explicit Nmea2000Attitude(const DeviceSetup& setup)
      : Nmea2000Device(setup, compass), readings_(setup) {}

 private:
  void measure(Stamp at, std::uint8_t address, Wire& out) override {
    const auto reading = readings_.at(trajectory().at(at), mounting());
    const auto sequence = static_cast<std::uint8_t>(samples() % attitude_sequences);

    wire::nmea2000::Attitude tilt;
    tilt.source = address;
    tilt.sequence = sequence;
    tilt.roll_rad = reading.roll_rad;
    tilt.pitch_rad = reading.pitch_rad;
    out.send(encode(tilt));

    wire::nmea2000::VesselHeading heading;
    heading.source = address;
    heading.sequence = sequence;
    heading.heading_rad = reading.heading_rad;
    const bool magnetic = reading.reference == measurement::HeadingReference::magnetic_north;
    heading.reference = magnetic ? wire::nmea2000::magnetic_north : wire::nmea2000::true_north;
    heading.variation_rad = reading.variation_rad;
    out.send(encode(heading));

    wire::nmea2000::RateOfTurn turn;
    turn.source = address;
    turn.sequence = sequence;
    turn.rate_radps = reading.rate_of_turn_radps;
    out.send(encode(turn));
  }

  AttitudeReadings readings_;
};

}  // namespace

DevicePtr make_nmea2000_attitude(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Attitude>(setup);
}

}  // namespace drydock::emulate
