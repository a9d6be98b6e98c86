#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "drivers/bus/outside_values.hpp"
#include "drivers/bus/participant.hpp"

namespace drydock::bus {

/// The messages of geometry_msgs, nav_msgs and sensor_msgs that an estimator may publish.
enum class OutsideType : std::uint8_t { imu, odometry, pose, twist, fix };

/// Reads the estimates of another program from a topic.
class OutsideReader {
 public:
  struct Heard {
    OutsideValues values;
    measurement::Stamp sent_at{};  ///< by the clock of the writer
  };

  /// `topic` is ROS 2's name of it: /my/odometry. Throws bus::Error.
  OutsideReader(const Participant& participant, const std::string& topic, OutsideType type);
  ~OutsideReader();
  OutsideReader(const OutsideReader&) = delete;
  OutsideReader& operator=(const OutsideReader&) = delete;

  /// Gives what has come since the last call, in order. Never waits.
  void take(const std::function<void(const Heard&)>& to);
  /// Returns when something has come since the last take(), or after `longest`.
  void wait(std::chrono::nanoseconds longest) const;
  std::size_t matched_writers() const;
  /// Messages whose content cannot be an estimate: not finite, no rotation, or in unknown axes.
  std::uint64_t unusable() const;

 private:
  struct Source;
  std::unique_ptr<Source> source_;
};

}  // namespace drydock::bus
