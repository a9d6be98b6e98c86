#include "drivers/wire/j1939/mv5.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/can/j1939_device.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

namespace mv5 = wire::mv5;

constexpr std::uint8_t function_of_unit = 145, industry_of_unit = 2;  // a real unit's NAME

// Duration of a frame of 8 bytes with a 29-bit identifier at 250 kbit/s.
constexpr double mv5_frame_time_s = 0.54e-3;

std::uint64_t mv5_name(const DeviceConfig& config) {
  auto name = name_for(config, function_of_unit, 0);
  name.manufacturer_code = mv5::manufacturer;
  name.industry_group = industry_of_unit;
  return wire::j1939::to_value(name);
}

/// SAE's order: lateral, longitudinal, vertical.
std::array<std::optional<double>, 3> in_sae_order(const Eigen::Vector3d& v) {
  return {v.y(), v.x(), v.z()};
}

class Mv5Imu final : public J1939Device {
 public:
  explicit Mv5Imu(const DeviceSetup& setup)
      : J1939Device(setup, mv5_name(setup.config), mv5::default_address),
        ideal_(setup.imu_sampler()),
        errors_(setup.imu_errors()) {}

 private:
  void report(Stamp at, std::uint8_t address, Wire& out) override {
    const auto measured = errors_.apply(ideal_.at(at));
    const double age_s = measurement::seconds(latency());
    out.send(encode(slope(at, address, age_s)));
    mv5::Acceleration acceleration;
    acceleration.source = address;
    acceleration.acceleration_mps2 = in_sae_order(measured.specific_force);
    out.send(encode(acceleration));
    mv5::AngularRate rate;
    rate.source = address;
    rate.rate_radps = in_sae_order(measured.angular_rate);
    rate.latency_s = age_s + 2 * mv5_frame_time_s;
    out.send(encode(rate));
  }

  /// Angles against north, west, up, since the device's Z points up.
  mv5::SlopeSensor slope(Stamp at, std::uint8_t address, double age_s) const {
    const Eigen::Matrix3d sensor_to_ned =
        trajectory().at(at).body_to_ned * mounting().sensor_to_body;
    const Eigen::Matrix3d sensor_to_nwu = Eigen::Vector3d(1, -1, -1).asDiagonal() * sensor_to_ned;
    const frame::Euler attitude = frame::euler(Eigen::Matrix3d(sensor_to_nwu.transpose()));
    mv5::SlopeSensor slope;
    slope.source = address;
    slope.pitch_rad = attitude.pitch;
    slope.roll_rad = attitude.roll;
    slope.latency_s = age_s;
    return slope;
  }

  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_mv5_imu(const DeviceSetup& setup) { return std::make_unique<Mv5Imu>(setup); }

}  // namespace drydock::emulate
