#include <cmath>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

class Nmea0183EmLog final : public SamplingDevice {
 public:
  explicit Nmea0183EmLog(const DeviceSetup& setup)
      : SamplingDevice(setup),
        errors_(setup.primary_errors()),
        samples_per_second_(std::max<std::uint64_t>(1, std::llround(setup.config.rate_hz))) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto ideal = sensor::ideal_log(trajectory(), at, mounting());
    const Eigen::Vector3d speed =
        errors_.apply({*ideal.longitudinal_mps, *ideal.transverse_mps, 0}, at);
    distance_m_ += std::abs(speed.x()) / rate_hz();

    wire::Vbw vbw;
    vbw.water_longitudinal_mps = speed.x();
    vbw.water_transverse_mps = speed.y();
    send(vbw, out);
    wire::Vhw vhw;
    vhw.speed_mps = speed.x();
    send(vhw, out);
    if (samples() % samples_per_second_ == 0) {
      wire::Vlw vlw;
      vlw.water_total_m = vlw.water_trip_m = distance_m_;
      send(vlw, out);
    }
  }

  template <class Sentence>
  void send(const Sentence& sentence, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  sensor::ErrorModel errors_;
  std::uint64_t samples_per_second_;
  double distance_m_ = 0;  ///< since boot
  std::array<std::uint8_t, 128> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_em_log(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183EmLog>(setup);
}

}  // namespace drydock::emulate
