#include <cmath>

#include "hil/emulate/can/nmea2000_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/log_readings.hpp"

namespace drydock::emulate {
namespace {

namespace n2k = wire::nmea2000;

constexpr std::array log_sends{n2k::Speed::pgn, n2k::DistanceLog::pgn};
// NMEA 2000 class "navigation", function "speed".
constexpr Nmea2000Product speed_log{"speed log", 155, 60, 0x25, log_sends, {}};
constexpr std::uint8_t log_sequences = 253;  // SIDs above 252 are reserved

class Nmea2000Log final : public Nmea2000Device {
 public:
  explicit Nmea2000Log(const DeviceSetup& setup)
      : Nmea2000Device(setup, speed_log),
        readings_(setup),
        samples_per_second_(std::max<std::uint64_t>(1, std::llround(setup.config.rate_hz))) {}

 private:
  void measure(Stamp at, std::uint8_t address, Wire& out) override {
    send_speed(readings_.at(trajectory(), at, mounting(), rate_hz()).x(), address, out);
    if (reports_++ % samples_per_second_ == 0) send_distance(at, address, out);
  }

  void send_speed(double along_mps, std::uint8_t address, Wire& out) {
    n2k::Speed speed;
    speed.source = address;
    speed.sequence = static_cast<std::uint8_t>(samples() % log_sequences);
    speed.water_mps = std::abs(along_mps);
    speed.sensor = n2k::Speed::electromagnetic;
    speed.direction = along_mps < 0 ? n2k::Speed::reverse : n2k::Speed::forward;
    out.send(encode(speed));
  }

  void send_distance(Stamp at, std::uint8_t address, Wire& out) {
    n2k::DistanceLog log;
    log.source = address;
    log.utc_ns = device_time(at).time_since_epoch().count();
    log.total_m = log.trip_m = readings_.distance_m();
    send_packet(log, packets_++, out);
  }

  LogReadings readings_;
  std::uint64_t samples_per_second_;
  std::uint64_t reports_ = 0;
  std::uint8_t packets_ = 0;
};

}  // namespace

DevicePtr make_nmea2000_log(const DeviceSetup& setup) {
  return std::make_unique<Nmea2000Log>(setup);
}

}  // namespace drydock::emulate
