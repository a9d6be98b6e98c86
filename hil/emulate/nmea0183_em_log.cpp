#include <cmath>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/log_readings.hpp"

namespace drydock::emulate {
namespace {

class Nmea0183EmLog final : public SamplingDevice {
 public:
  explicit Nmea0183EmLog(const DeviceSetup& setup)
      : SamplingDevice(setup),
        readings_(setup),
        samples_per_second_(std::max<std::uint64_t>(1, std::llround(setup.config.rate_hz))) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const Eigen::Vector2d speed = readings_.at(trajectory(), at, mounting(), rate_hz());
    wire::Vbw vbw;
    vbw.water_longitudinal_mps = speed.x();
    vbw.water_transverse_mps = speed.y();
    send(vbw, out);
    wire::Vhw vhw;
    vhw.speed_mps = speed.x();
    send(vhw, out);
    if (samples() % samples_per_second_ == 0) {
      wire::Vlw vlw;
      vlw.water_total_m = vlw.water_trip_m = readings_.distance_m();
      send(vlw, out);
    }
  }

  template <class Sentence>
  void send(const Sentence& sentence, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  LogReadings readings_;
  std::uint64_t samples_per_second_;
  std::array<std::uint8_t, 128> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_em_log(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183EmLog>(setup);
}

}  // namespace drydock::emulate
