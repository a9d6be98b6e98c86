#include "drivers/wire/cia404_imu.hpp"

#include "hil/emulate/canopen_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

/// CiA 404 (194h), with analogue inputs (2).
constexpr std::uint32_t measuring_device = 0x00020194;

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class Cia404Imu final : public CanopenDevice {
 public:
  explicit Cia404Imu(const DeviceSetup& setup)
      : CanopenDevice(setup, measuring_device),
        gyro_errors_(setup.primary_errors()),
        accelerometer_errors_(setup.secondary_errors()) {}

 private:
  void report(Stamp at, Wire& out) override {
    const auto ideal = sensor::ideal_imu(trajectory(), at, mounting());
    wire::cia404_imu::ImuSet set;
    set.node = node();
    set.rate_radps = components(gyro_errors_.apply(ideal.angular_rate));
    set.specific_force_mps2 = components(accelerometer_errors_.apply(ideal.specific_force));
    for (const wire::CanFrame& frame : encode(set)) out.send(frame);
  }

  sensor::ErrorModel gyro_errors_, accelerometer_errors_;
};

}  // namespace

DevicePtr make_cia404_imu(const DeviceSetup& setup) { return std::make_unique<Cia404Imu>(setup); }

}  // namespace drydock::emulate
