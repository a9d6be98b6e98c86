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
    if (reading.reference == measurement::HeadingReference::magnetic_north)
      return send_magnetic(reading, out);
    send(wire::Ths{wire::Talker{"HE"}, reading.heading_rad, {'A'}}, out);
    send(wire::Hdt{wire::Talker{"HE"}, reading.heading_rad}, out);
  }

  void send_magnetic(const measurement::AttitudeSample& reading, Wire& out) {
    send(wire::Hdg{wire::Talker{"HC"}, reading.heading_rad, {}, reading.variation_rad}, out);
    send(wire::Hdm{wire::Talker{"HC"}, reading.heading_rad}, out);
  }

  template <class Sentence>
  void send(const Sentence& sentence, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  AttitudeReadings readings_;
  std::array<std::uint8_t, 64> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_attitude(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183Attitude>(setup);
}

}  // namespace drydock::emulate
