#include <algorithm>
#include <cmath>

#include "hil/emulate/can/nmea2000_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr std::array sends{wire::nmea2000::Pressure::pgn, wire::nmea2000::Temperature::pgn,
                           wire::nmea2000::WaterDepth::pgn};
// NMEA 2000 class "sensor communication interface", function "pressure".
constexpr Nmea2000Product product{"depth sensor", 140, 75, 0x23, sends, {}};
constexpr double echo_range_m = 200;
constexpr double temperature_interval_s = 2, depth_interval_s = 1;  // from NMEA 2000
constexpr unsigned sequences = 253;                                 // SIDs above 252 are reserved

class Nmea2000Depth final : public Nmea2000Device {
 public:
  explicit Nmea2000Depth(const DeviceSetup& setup)
      : Nmea2000Device(setup, product),
        errors_(setup.primary_errors()),
        instance_(static_cast<std::uint8_t>(setup.config.instance.value_or(0))) {}

 private:
  void measure(Stamp at, std::uint8_t address, Wire& out) override {
    const auto truth = trajectory().at(at);
    const auto ideal = sensor::ideal_depth(truth, trajectory().ocean(), mounting());
    send_pressure(*ideal.pressure_pa, at, address, out);
    if (each(temperature_interval_s)) send_temperature(*ideal.temperature_k, address, out);
    if (each(depth_interval_s))
      send_depth(sensor::altitude_at(truth, trajectory().ocean(), mounting()), address, out);
    ++reports_;
  }

  /// True for the first report and then every `interval_s`, by the count of reports.
  bool each(double interval_s) const {
    const auto period = std::max<std::uint64_t>(1, std::llround(interval_s * rate_hz()));
    return reports_ % period == 0;
  }
  std::uint8_t sequence() const { return static_cast<std::uint8_t>(samples() % sequences); }

  void send_pressure(double ideal_pa, Stamp at, std::uint8_t address, Wire& out) {
    wire::nmea2000::Pressure pressure;
    pressure.source = address;
    pressure.sequence = sequence();
    pressure.instance = instance_;
    pressure.kind = wire::nmea2000::Pressure::water;
    pressure.pressure_pa = errors_.apply(ideal_pa, at);
    out.send(encode(pressure));
  }

  void send_temperature(double actual_k, std::uint8_t address, Wire& out) {
    wire::nmea2000::Temperature temperature;
    temperature.source = address;
    temperature.sequence = sequence();
    temperature.instance = 0;
    temperature.kind = wire::nmea2000::Temperature::sea;
    temperature.actual_k = actual_k;
    out.send(encode(temperature));
  }

  void send_depth(double altitude, std::uint8_t address, Wire& out) {
    wire::nmea2000::WaterDepth below;
    below.source = address;
    below.sequence = sequence();
    if (altitude > 0 && altitude <= echo_range_m) below.depth_m = altitude;
    below.offset_m = 0;
    below.maximum_range_m = echo_range_m;
    out.send(encode(below));
  }

  sensor::ErrorModel errors_;
  std::uint64_t reports_ = 0;  ///< before the current one
  std::uint8_t instance_;      ///< the one that the rig's driver takes
};

}  // namespace

DevicePtr make_nmea2000_depth(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Depth>(setup);
}

}  // namespace drydock::emulate
