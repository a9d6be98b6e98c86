#include <numbers>

#include "hil/emulate/can/nmea2000_device.hpp"
#include "hil/emulate/can/ordered_actuator.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr std::array sends{wire::nmea2000::Rudder::pgn, wire::nmea2000::Engine::pgn};
// NMEA 2000 class "steering and control surfaces", function "rudder".
constexpr Nmea2000Product product{"actuators", 155, 40, 0x24, sends, sends};

class Nmea2000Actuators final : public Nmea2000Device {
 public:
  explicit Nmea2000Actuators(const DeviceSetup& setup)
      : Nmea2000Device(setup, product),
        angle_errors_(setup.primary_errors()),
        shaft_errors_(setup.secondary_errors()),
        instance_(static_cast<std::uint8_t>(setup.config.instance.value_or(0))),
        patience_(measurement::from_seconds(setup.config.stale_after_s)),
        actuators_{OrderedActuator{setup, 0}, OrderedActuator{setup, 1}, OrderedActuator{setup, 2},
                   OrderedActuator{setup, measurement::propeller_number}} {}

 private:
  void measure(Stamp at, std::uint8_t address, Wire& out) override {
    for (OrderedActuator& actuator : actuators_)
      if (actuator.times_out(at, patience_)) actuator.rest(at);
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

  /// Orders come from any node of the bus.
  void hear_message(const wire::CanFrame& frame, Stamp now, Wire&) override {
    using wire::nmea2000::Engine;
    using wire::nmea2000::Rudder;
    const auto id = wire::j1939::identify(frame);
    if (id->pgn == Rudder::pgn) {
      if (const auto rudder = wire::nmea2000::decode<Rudder>(id->source, frame.payload()))
        obey(*rudder, now);
    } else if (id->pgn == Engine::pgn) {
      const auto engine = wire::nmea2000::decode<Engine>(id->source, frame.payload());
      if (engine && engine->instance == instance_ && engine->speed_radps)
        actuators_[measurement::propeller_number].order(*engine->speed_radps, now);
    }
  }

  void obey(const wire::nmea2000::Rudder& rudder, Stamp now) {
    if (!rudder.instance || *rudder.instance >= measurement::propeller_number) return;
    const auto angle = ordered_angle(rudder);
    if (!angle) return;
    const bool steers = *rudder.instance == 0;  // its positive angle is to starboard on the wire
    auto& actuator = actuators_[*rudder.instance];
    const double value = steers ? -*angle : *angle;
    actuator.order(rudder.angle_order_rad ? value : actuator.within_limits(value), now);
  }

  /// Empty: the message is a report of another rudder. A direction without an angle is the whole
  /// way, on which the vehicle's stop ends it.
  static std::optional<double> ordered_angle(const wire::nmea2000::Rudder& rudder) {
    constexpr std::uint8_t to_starboard = 1, to_port = 2;
    if (rudder.angle_order_rad) return rudder.angle_order_rad;
    if (rudder.direction_order == to_starboard) return std::numbers::pi / 2;
    if (rudder.direction_order == to_port) return -std::numbers::pi / 2;
    return {};
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
  std::chrono::nanoseconds patience_;
  std::array<OrderedActuator, measurement::actuator_count> actuators_;
};

}  // namespace

DevicePtr make_nmea2000_actuators(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Actuators>(setup);
}

}  // namespace drydock::emulate
