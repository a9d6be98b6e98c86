#include "hil/emulate/can/nmea2000_name.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr std::uint8_t preferred_address = 0x24;
// NMEA 2000 class "steering and control surfaces", function "rudder".
constexpr std::uint8_t device_class = 40, rudder_function = 155;

class Nmea2000Actuators final : public J1939Device {
 public:
  explicit Nmea2000Actuators(const DeviceSetup& setup)
      : J1939Device(setup, marine_name(setup.config, rudder_function, device_class),
                    preferred_address),
        angle_errors_(setup.primary_errors()),
        shaft_errors_(setup.secondary_errors()),
        instance_(static_cast<std::uint8_t>(setup.config.instance.value_or(0))) {}

 private:
  void report(Stamp at, std::uint8_t address, Wire& out) override {
    const auto ideal = sensor::ideal_actuators(trajectory().at(at));
    const Eigen::Vector3d angles =
        angle_errors_.apply({*ideal.rudder_rad, *ideal.stern_plane_rad, *ideal.bow_plane_rad}, at);
    // On the wire an angle that turns to starboard is positive; here one that turns to port is
    // positive.
    send_angle(0, -angles.x(), address, out);
    send_angle(1, angles.y(), address, out);
    send_angle(2, angles.z(), address, out);

    wire::nmea2000::Engine engine;
    engine.source = address;
    engine.instance = instance_;
    engine.speed_radps = shaft_errors_.apply(*ideal.propeller_radps, at);
    out.send(encode(engine));
  }

  static void send_angle(std::uint8_t instance, double position, std::uint8_t address, Wire& out) {
    wire::nmea2000::Rudder rudder;
    rudder.source = address;
    rudder.instance = instance;
    rudder.position_rad = position;
    out.send(encode(rudder));
  }

  sensor::ErrorModel angle_errors_, shaft_errors_;
  std::uint8_t instance_;  ///< the one that the rig's driver takes
};

}  // namespace

DevicePtr make_nmea2000_actuators(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Actuators>(setup);
}

}  // namespace drydock::emulate
