#include "drivers/wire/can/xsens.hpp"

#include "drivers/measurement/units.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

constexpr std::chrono::microseconds tick_length{100};

// Bits of the status word: self-test passed, filter valid, and clipping of each axis.
constexpr std::uint32_t sound = 0x3, acceleration_clipped = 0x700, rate_clipped = 0x3800;
// Ranges of the MTi-600 (MT1603P).
constexpr double acceleration_range_mps2 = 10 * units::standard_gravity;
constexpr double rate_range_radps = 2000 * units::degree;

wire::xsens::Identifiers identifiers_of(const rig_config::XsensConfig& config) {
  wire::xsens::Identifiers identifiers;
  identifiers.extended = config.extended;
  for (const auto& [message, id] : config.identifiers) identifiers.set(message, id);
  return identifiers;
}

std::array<double, 3> clipped(const Eigen::Vector3d& v, double range) {
  const Eigen::Vector3d held = v.cwiseMax(-range).cwiseMin(range);
  return {held.x(), held.y(), held.z()};
}

class XsensImu final : public SamplingDevice {
 public:
  explicit XsensImu(const DeviceSetup& setup)
      : SamplingDevice(setup),
        identifiers_(identifiers_of(setup.config.xsens)),
        boot_(setup.boot),
        ideal_(setup.imu_sampler()),
        errors_(setup.imu_errors()) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = errors_.apply(ideal_.at(at));
    const Eigen::Vector3d rate = measured.angular_rate;
    const Eigen::Vector3d force = measured.specific_force;
    std::uint32_t status = sound;
    if (rate.cwiseAbs().maxCoeff() >= rate_range_radps) status |= rate_clipped;
    if (force.cwiseAbs().maxCoeff() >= acceleration_range_mps2) status |= acceleration_clipped;

    const auto say = [&](const wire::xsens::Message& message) {
      out.send(wire::xsens::encode(message, identifiers_));
    };
    say(wire::xsens::SampleTime{
        static_cast<std::uint32_t>((device_time(at) - boot_) / tick_length)});
    say(wire::xsens::GroupCounter{static_cast<std::uint16_t>(samples())});
    say(wire::xsens::StatusWord{status});
    say(wire::xsens::RateOfTurn{clipped(rate, rate_range_radps)});
    say(wire::xsens::Acceleration{clipped(force, acceleration_range_mps2)});
  }

  wire::xsens::Identifiers identifiers_;
  Stamp boot_;
  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_xsens_imu(const DeviceSetup& setup) { return std::make_unique<XsensImu>(setup); }

}  // namespace drydock::emulate
