#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "hil/steer/autopilot_session.hpp"
#include "rig_config/load.hpp"

/// The other side of ArduPilot's JSON physics interface, written from its description.
namespace drydock::steer::test {

inline constexpr double degree = 0.017453292519943295;

inline measurement::Stamp bench_s(double t) {
  return measurement::stamp_from_ns(1'700'000'000'000'000'000) + measurement::from_seconds(t);
}

using Pulses = std::vector<std::uint16_t>;

inline std::vector<std::uint8_t> packet(std::uint16_t magic, std::uint16_t rate_hz,
                                        std::uint32_t count, const Pulses& pulses) {
  std::vector<std::uint8_t> bytes;
  const auto put = [&](std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  };
  put(magic, 2);
  put(rate_hz, 2);
  put(count, 4);
  for (const auto pulse : pulses) put(pulse, 2);
  return bytes;
}

/// What the autopilot reads of an answer.
struct Physics {
  double timestamp_s = 0;
  std::array<double, 3> gyro{}, accelerometer{}, position{}, velocity{};
  std::array<double, 4> quaternion{};
  double range_m = 0;

  double heading_rad() const {
    const auto& [w, x, y, z] = quaternion;
    return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  }
};

inline Physics read(std::string_view line) {
  const auto json = nlohmann::json::parse(line);
  Physics p;
  p.timestamp_s = json.at("timestamp");
  p.gyro = json.at("imu").at("gyro");
  p.accelerometer = json.at("imu").at("accel_body");
  p.position = json.at("position");
  p.velocity = json.at("velocity");
  p.quaternion = json.at("quaternion");
  p.range_m = json.at("rng_1");
  return p;
}

/// Physics and autopilot in one thread; bench time runs as the autopilot's.
class Loop {
 public:
  explicit Loop(rig_config::MissionConfig mission, std::uint16_t rate_hz = 400)
      : mission_(std::move(mission)),
        motion_(mission_, bench_s(0)),
        session_(motion_, mission_),
        rate_hz_(rate_hz) {}

  Physics step(const Pulses& pulses) {
    Pulses all = pulses;
    all.resize(16, 1500);
    const auto bytes = packet(18458, rate_hz_, ++count_, all);
    return state_ = read(session_.answer(bytes, bench_s(count_ / static_cast<double>(rate_hz_))));
  }
  Physics hold(const Pulses& pulses, double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds * rate_hz_));
    for (int i = 0; i < steps; ++i) step(pulses);
    return state_;
  }

  rig_config::MissionConfig mission_;
  motion::SteeredTrajectory motion_;
  AutopilotSession session_;
  std::uint16_t rate_hz_;
  std::uint32_t count_ = 0;
  Physics state_;
};

/// `vehicle`: a shipped file; empty: the vehicle is kinematic.
inline rig_config::MissionConfig mission_of(const std::string& vehicle, double depth_m = 5) {
  const std::string named = vehicle.empty() ? "" : "\nvehicle = \"../vehicles/" + vehicle + "\"";
  const std::string text =
      "[mission]\nlatitude_deg = 47.0\nlongitude_deg = 8.0\nheading_deg = 90.0\n"
      "depth_m = " +
      std::to_string(depth_m) + named +
      "\n[steering]\nfrom = \"ardupilot\"\n"
      "listen = \"127.0.0.1:0\"\n"
      "[ocean]\nbed = { kind = \"plane\", depth_m = 50.0 }\n";
  return rig_config::load_mission_text(text, DRYDOCK_SOURCE_DIR "/rig_config/missions/test.toml")
      .value();
}

/// The mixing of ArduSub's frame VECTORED: roll, yaw, vertical (up), forward, lateral, each -1
/// to 1.
inline Pulses vectored(double yaw, double up, double forward, double lateral) {
  const std::array<double, 6> outputs{yaw - forward + lateral,
                                      -yaw - forward - lateral,
                                      -yaw + forward + lateral,
                                      yaw + forward - lateral,
                                      -up,
                                      -up};
  Pulses pulses;
  for (const double output : outputs)
    pulses.push_back(
        static_cast<std::uint16_t>(std::lround(1500 + 400 * std::clamp(output, -1.0, 1.0))));
  return pulses;
}

}  // namespace drydock::steer::test
