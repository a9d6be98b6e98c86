#include "drivers/wire/aceinna.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/j1939_device.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr std::uint8_t preferred_address = 0x80;
constexpr std::uint16_t manufacturer = 823;
constexpr std::uint8_t inertial_function = 131;

// A frame of 8 bytes with a 29-bit identifier at 250 kbit/s.
constexpr double frame_time_s = 0.54e-3;

std::uint64_t name_value(const DeviceConfig& config) {
  auto name = name_for(config, inertial_function, 0);
  name.manufacturer_code = manufacturer;
  // In this vendor's reversed layout bit 63 is the top of the identity number; who reads the NAME
  // as SAE has it finds "arbitrary address capable" there. Set, both readings agree.
  name.identity_number |= 1U << 20;
  return wire::aceinna::to_value(name);
}

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class AceinnaImu final : public J1939Device {
 public:
  explicit AceinnaImu(const DeviceSetup& setup)
      : J1939Device(setup, name_value(setup.config), preferred_address),
        gyro_errors_(setup.primary_errors()),
        accelerometer_errors_(setup.secondary_errors()) {}

 private:
  void report(Stamp at, std::uint8_t address, Wire& out) override {
    const auto ideal = sensor::ideal_imu(trajectory(), at, mounting());
    const double age_s = measurement::seconds(latency());

    const Eigen::Matrix3d sensor_to_ned =
        trajectory().at(at).body_to_ned * mounting().sensor_to_body;
    const frame::Euler attitude = frame::euler(Eigen::Matrix3d(sensor_to_ned.transpose()));
    wire::aceinna::SlopeSensor slope;
    slope.source = address;
    slope.pitch_rad = attitude.pitch;
    slope.roll_rad = attitude.roll;
    slope.latency_s = age_s;
    out.send(encode(slope));

    wire::aceinna::Acceleration acceleration;
    acceleration.source = address;
    acceleration.acceleration_mps2 = components(accelerometer_errors_.apply(ideal.specific_force));
    out.send(encode(acceleration));

    wire::aceinna::AngularRate rate;
    rate.source = address;
    rate.rate_radps = components(gyro_errors_.apply(ideal.angular_rate));
    rate.latency_s = age_s + 2 * frame_time_s;
    out.send(encode(rate));
  }

  sensor::ErrorModel gyro_errors_, accelerometer_errors_;
};

}  // namespace

DevicePtr make_aceinna_imu(const DeviceSetup& setup) { return std::make_unique<AceinnaImu>(setup); }

}  // namespace drydock::emulate
