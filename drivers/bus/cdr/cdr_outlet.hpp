#pragma once

#include <memory>
#include <string>

#include "drivers/bus/cdr/cdr.hpp"
#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/bus/schema.hpp"

/// The parts of a CdrPublisher. Only cdr_publisher.cpp includes this file.
namespace drydock::bus {

/// In the form that rosbag2 writes: keep the last ten, reliable, volatile.
inline constexpr const char* offered_qos =
    "- history: 1\n  depth: 10\n  reliability: 1\n  durability: 2\n";

/// One topic of a sink. It is an outlet in the sense of outlets.hpp.
template <class Message>
class CdrOutlet {
 public:
  CdrOutlet(CdrSink& sink, CdrEncoder& encoder, const std::string& dds_topic,
            const std::string& frame)
      : sink_(&sink), encoder_(&encoder), message_(new Message{}) {
    const auto& type = message_type<Message>;
    const std::string name = ros2_type(type.descriptor->m_typename);
    CdrSink::Topic topic{dds_topic.substr(2), name, ros2_schema(name), {}};
    topic.metadata.emplace_back("offered_qos_profiles", offered_qos);
    if (!type.hash.empty()) topic.metadata.emplace_back("topic_type_hash", type.hash);
    topic_ = sink.add_topic(topic);
    message_->header.frame_id = dds_string_dup(frame.c_str());
  }

  Message& message() { return *message_; }
  void write(Stamp at) {
    if (sink_->wanted(topic_)) sink_->put(topic_, at, encoder_->encode(*message_));
  }

 private:
  struct Release {
    void operator()(Message* message) const {
      dds_sample_free(message, message_type<Message>.descriptor, DDS_FREE_CONTENTS);
      delete message;
    }
  };

  CdrSink* sink_;
  CdrEncoder* encoder_;
  std::unique_ptr<Message, Release> message_;
  std::uint32_t topic_ = 0;
};

}  // namespace drydock::bus
