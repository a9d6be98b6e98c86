#include "drivers/wire/can/sbg.hpp"

#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

namespace sbg = wire::sbg;

std::array<double, 3> to_array(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

class SbgImu final : public SamplingDevice {
 public:
  explicit SbgImu(const DeviceSetup& setup)
      : SamplingDevice(setup),
        boot_(setup.boot),
        ideal_(setup.imu_sampler()),
        errors_(setup.imu_errors()) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = errors_.apply(ideal_.at(at));
    const auto since_boot = (device_time(at) - boot_) / std::chrono::microseconds{1};
    sbg::ImuInfo info;
    info.time_us = static_cast<std::uint32_t>(since_boot);  // wraps after 71.6 min
    info.temperature_k = wire::zero_celsius_k + 25;
    out.send(encode(sbg::Message{info}));
    out.send(encode(sbg::Message{sbg::ImuAcceleration{to_array(measured.specific_force)}}));
    out.send(encode(sbg::Message{sbg::ImuRate{to_array(measured.angular_rate)}}));
  }

  Stamp boot_;
  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_sbg_imu(const DeviceSetup& setup) { return std::make_unique<SbgImu>(setup); }

}  // namespace drydock::emulate
