#pragma once

#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/live/server.hpp"

namespace drydock::live {

/// The bus's topics on a server. Each is a channel with its ros2msg definition.
class LiveTopics final : public bus::CdrSink {
 public:
  /// The server must outlive it.
  explicit LiveTopics(Server& server) : server_(server) {}

  std::uint32_t add_topic(const Topic& topic) override {
    return server_.add_channel({0, topic.name, "cdr", topic.type, topic.schema, "ros2msg"},
                               keep_of(topic.type));
  }
  bool wanted(std::uint32_t topic) const override { return server_.wanted(topic); }
  void put(std::uint32_t topic, measurement::Stamp at, std::span<const std::uint8_t> cdr) override {
    server_.publish(topic, at, cdr);
  }

 private:
  /// Each message of these types tells everything, and many come in a second.
  static Keep keep_of(std::string_view type) {
    const bool dense = type == "sensor_msgs/msg/Imu" || type == "sensor_msgs/msg/NavSatFix" ||
                       type == "nav_msgs/msg/Odometry";
    return dense ? Keep::some : Keep::all;
  }

  Server& server_;
};

}  // namespace drydock::live
