#include "drivers/wire/epson_imu.hpp"

#include "hil/emulate/canopen_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

// Objects 1000h, 1001h and the unit of each process value, as the G552's dictionary holds them.
constexpr std::uint32_t measuring_device = 0x00020194;
constexpr std::uint32_t degree_per_second = 0x00410300, milli_g = 0xFDF10000, celsius = 0x002D0000;
constexpr std::uint16_t unit_index = 0x6131;
constexpr std::uint16_t out_of_range = 0xFF00;  // CiA 301: device specific
constexpr std::uint8_t manufacturer_error = 0x81;

constexpr double water_k = 283.15;

std::array<double, 3> components(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

class EpsonImu final : public CanopenDevice {
 public:
  EpsonImu(const DeviceSetup& setup, const wire::epson::Scale& scale)
      : CanopenDevice(setup, measuring_device),
        scale_(scale),
        gyro_errors_(setup.primary_errors()),
        accelerometer_errors_(setup.secondary_errors()) {}

 private:
  void report(Stamp at, Wire& out) override {
    const auto ideal = sensor::ideal_imu(trajectory(), at, mounting());
    wire::epson::Sample sample;
    sample.node = node();
    sample.counter = counter_++;
    sample.rate_radps = components(gyro_errors_.apply(ideal.angular_rate));
    sample.specific_force_mps2 = components(accelerometer_errors_.apply(ideal.specific_force));
    const bool sound = fits(sample, scale_);
    set_fault(sound ? 0 : out_of_range, sound ? 0 : manufacturer_error, out);
    for (const wire::CanFrame& frame : encode(sample, scale_)) out.send(frame);
    out.send(encode(wire::epson::Condition{node(), sample.counter, water_k, 0}));
  }

  std::optional<Object> object(const wire::canopen::ObjectEntry& entry) const override {
    if (entry.index != unit_index || entry.subindex < 1 || entry.subindex > 7) return {};
    if (entry.subindex <= 3) return Object{degree_per_second};
    return Object{entry.subindex <= 6 ? milli_g : celsius};
  }

  wire::epson::Scale scale_;
  std::uint16_t counter_ = 0;
  sensor::ErrorModel gyro_errors_, accelerometer_errors_;
};

}  // namespace

DevicePtr make_epson_g550(const DeviceSetup& setup) {
  return std::make_unique<EpsonImu>(setup, wire::EpsonG550::scale);
}

DevicePtr make_epson_g552(const DeviceSetup& setup) {
  return std::make_unique<EpsonImu>(setup, wire::EpsonG552::scale);
}

}  // namespace drydock::emulate
