#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::bus {

/// Takes messages that do not go to DDS: a recording, a viewer. Each sink numbers its own topics.
class CdrSink {
 public:
  struct Topic {
    std::string name;    ///< "/imu/data"
    std::string type;    ///< "sensor_msgs/msg/Imu"
    std::string schema;  ///< ros2_schema(type)
    /// The same entries as rosbag2 writes: offered QoS profiles, type hash.
    std::vector<std::pair<std::string, std::string>> metadata;
  };

  virtual ~CdrSink() = default;
  virtual std::uint32_t add_topic(const Topic& topic) = 0;
  /// False if nobody would receive a message now.
  virtual bool wanted(std::uint32_t topic) const = 0;
  virtual void put(std::uint32_t topic, measurement::Stamp at,
                   std::span<const std::uint8_t> cdr) = 0;
};

}  // namespace drydock::bus
