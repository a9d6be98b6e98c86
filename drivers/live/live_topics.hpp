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
    return server_.add_channel({0, topic.name, "cdr", topic.type, topic.schema, "ros2msg"});
  }
  bool wanted(std::uint32_t topic) const override { return server_.wanted(topic); }
  void put(std::uint32_t topic, measurement::Stamp at, std::span<const std::uint8_t> cdr) override {
    server_.publish(topic, at, cdr);
  }

 private:
  Server& server_;
};

}  // namespace drydock::live
