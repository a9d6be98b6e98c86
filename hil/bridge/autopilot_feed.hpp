#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "drivers/device/timed_framer.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/mavlink/mavlink.hpp"
#include "hil/bridge/body_motion.hpp"

namespace drydock::bridge {

/// Messages of motion, on average.
constexpr double most_per_second = 20;

struct FeedOptions {
  std::uint8_t system = 1, component = wire::mavlink::odometry_component;
  bool position_delta = true;  ///< sends VISION_POSITION_DELTA
  bool odometry = false;       ///< sends ODOMETRY
  std::uint16_t dvl = 0;       ///< index of the device in the rig
  std::optional<std::uint16_t> imu;
};

/// Of the pings of the DVL: what became of each, and how old those were that were sent.
struct FeedCounters {
  std::uint64_t pings = 0;
  std::uint64_t sent = 0;    ///< at the end of a message
  std::uint64_t first = 0;   ///< nothing was before them to measure a motion from
  std::uint64_t merged = 0;  ///< in the next message, because of 20 Hz
  std::uint64_t no_velocity = 0;
  std::uint64_t old = 0;
  std::uint64_t not_taken = 0;         ///< the autopilot's link was closed or slow
  std::uint64_t breaks = 0;            ///< the DVL fell silent
  std::uint64_t without_rotation = 0;  ///< of `sent`: angle_delta is 0
  std::chrono::nanoseconds total_age{}, oldest{}, total_interval{};  ///< of `sent`
  std::uint64_t autopilot_heartbeats = 0;
};

/// A DVL's measurements as an autopilot takes them over MAVLink. Sans-I/O. What must not be sent is
/// counted, and told when it begins and ends.
class AutopilotFeed {
 public:
  /// Gets one frame; false: the link did not take it.
  using Send = std::function<bool(wire::Bytes)>;
  using Tell = std::function<void(std::string_view line)>;

  AutopilotFeed(const FeedOptions& options, Send send, Tell tell);

  void on(const measurement::Measurement& measurement, Stamp now);
  /// The DVL no longer streams.
  void on_silence();
  /// From the autopilot.
  void receive(wire::Bytes bytes, Stamp now);
  /// Says that this component is there; call it once a second.
  void beat() { send(wire::mavlink::Heartbeat{}); }

  const FeedCounters& counters() const { return counters_; }

 private:
  enum class Trouble : std::uint8_t { none, no_velocity, old, silent, not_taken };

  void on_ping(const measurement::BottomVelocity& ping, Stamp now);
  void on_message(const wire::Mavlink::Message& message, Stamp now);
  bool within_rate(Stamp now);
  void send_motion(const measurement::BottomVelocity& ping, const Moved& moved, Stamp now);
  bool send(wire::Mavlink::Message message);
  void tell(Trouble trouble, std::string_view line);

  FeedOptions options_;
  Send send_;
  Tell tell_;
  RotationHistory rotation_;
  BodyMotion motion_;
  FeedCounters counters_;
  Trouble trouble_ = Trouble::none;
  std::uint8_t sequence_ = 0;
  Stamp rate_due_{};
  device::TimedFramer<wire::Mavlink::max_frame> framer_;
};

}  // namespace drydock::bridge
