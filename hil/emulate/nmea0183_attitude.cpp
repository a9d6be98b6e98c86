#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/attitude_readings.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

class Nmea0183Attitude final : public SamplingDevice {
 public:
  explicit Nmea0183Attitude(const DeviceSetup& setup) : SamplingDevice(setup), readings_(setup) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto reading = readings_.at(trajectory().at(at), mounting());
    wire::Ths ths{.talker = wire::Talker{"HE"}, .heading_rad = reading.heading_rad, .mode = {'A'}};
    out.send(wire::Bytes{bytes_}.first(wire::encode(ths, bytes_)));
    wire::Hdt hdt{.talker = wire::Talker{"HE"}, .heading_rad = reading.heading_rad};
    out.send(wire::Bytes{bytes_}.first(wire::encode(hdt, bytes_)));
  }

  AttitudeReadings readings_;
  std::array<std::uint8_t, 64> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_attitude(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183Attitude>(setup);
}

}  // namespace drydock::emulate
