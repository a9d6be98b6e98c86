#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/make_emulated_device.hpp"
#include "tests/hil/frozen.hpp"

namespace drydock::emulate {

inline constexpr double degree = std::numbers::pi / 180;

/// 2023-11-14 22:13:20 UTC; GPS time of week 252818 s.
inline const Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);
inline Stamp at_s(double t) { return start + measurement::from_seconds(t); }

/// The same truth at all times since `start`.
struct Frozen final : motion::test::Frozen {
  explicit Frozen(const motion::Truth& truth) : motion::test::Frozen(truth, emulate::start) {}
  Frozen(const motion::Truth& truth, const rig_config::OceanConfig& ocean)
      : motion::test::Frozen(truth, ocean, emulate::start) {}
};

/// Under way at 20 m depth, 30 m above the bed. All values are different.
inline motion::Truth under_way() {
  motion::Truth truth;
  truth.latitude_rad = 47.123456 * degree;
  truth.longitude_rad = -8.765432 * degree;
  truth.height_m = -20;
  truth.roll_rad = 3 * degree;
  truth.pitch_rad = -4 * degree;
  truth.yaw_rad = -70 * degree;
  truth.body_to_ned = frame::body_to_ned({truth.roll_rad, truth.pitch_rad, truth.yaw_rad});
  truth.velocity_body = {2, 0.123, -0.045};
  truth.velocity_ned = truth.body_to_ned * truth.velocity_body;
  truth.specific_force = {0.7, -0.5, -9.78};
  truth.angular_rate = truth.rate_body = {0.01, -0.02, 0.03};
  truth.bed_depth_m = 50;
  truth.rudder_rad = 0.11;
  truth.stern_plane_rad = -0.07;
  truth.bow_plane_rad = 0.05;
  truth.propeller_radps = 150;
  return truth;
}

inline motion::Truth at_the_surface() {
  motion::Truth truth = under_way();
  truth.height_m = -0.1;
  return truth;
}

inline rig_config::DeviceConfig device(rig_config::DeviceKind kind, std::string protocol,
                                       double rate_hz = 1) {
  rig_config::DeviceConfig config;
  config.name = protocol + " device";
  config.kind = kind;
  const bool is_canopen = protocol.starts_with("cia40") || protocol.starts_with("epson");
  config.address = is_canopen ? 1 : 0;
  config.protocol = std::move(protocol);
  config.rate_hz = rate_hz;
  return config;
}

/// Records what a device sent and when, without a line between.
class Recorder final : public Wire {
 public:
  struct Message {
    Stamp at;
    std::vector<std::uint8_t> bytes;
  };
  struct Frame {
    Stamp at;
    wire::CanFrame frame;
  };

  void send(wire::Bytes bytes) override { messages.push_back({now, {bytes.begin(), bytes.end()}}); }
  void send(const wire::CanFrame& frame) override { frames.push_back({now, frame}); }
  void tell(std::string_view what) override { told.emplace_back(what); }

  /// Lets the device act at every deadline up to `end`.
  void run(EmulatedDevice& device, Stamp end) {
    for (auto due = device.deadline(); due && *due <= end; due = device.deadline()) {
      now = *due;
      device.tick(now, *this);
    }
    now = end;
  }

  std::vector<std::uint8_t> all_bytes() const {
    std::vector<std::uint8_t> all;
    for (const auto& m : messages) all.insert(all.end(), m.bytes.begin(), m.bytes.end());
    return all;
  }

  Stamp now = start;
  std::vector<Message> messages;
  std::vector<Frame> frames;
  std::vector<std::string> told;
};

inline std::string text(const Recorder::Message& message) {
  return {message.bytes.begin(), message.bytes.end()};
}

/// Runs a fresh device of this configuration until `seconds` after its boot.
inline Recorder record(const rig_config::DeviceConfig& config, const motion::Trajectory& trajectory,
                       double seconds, std::uint64_t seed = 1) {
  Recorder recorder;
  const auto made = make_emulated_device(config, trajectory, seed).value();
  recorder.run(*made, at_s(seconds));
  return recorder;
}

}  // namespace drydock::emulate
