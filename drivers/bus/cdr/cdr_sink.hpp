#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::bus {

/// Where messages go that do not go to DDS: a recording, a viewer. `Topic` numbers are its own.
class CdrSink {
 public:
  struct Topic {
    std::string name;    ///< "/imu/data"
    std::string type;    ///< "sensor_msgs/msg/Imu"
    std::string schema;  ///< ros2_schema(type)
    /// As rosbag2 has it: offered QoS profiles, type hash.
    std::vector<std::pair<std::string, std::string>> metadata;
  };

  virtual ~CdrSink() = default;
  virtual std::uint32_t add_topic(const Topic& topic) = 0;
  /// False: a message now would be for nobody.
  virtual bool wanted(std::uint32_t topic) const = 0;
  virtual void put(std::uint32_t topic, measurement::Stamp at,
                   std::span<const std::uint8_t> cdr) = 0;
};

}  // namespace drydock::bus
