#pragma once

#include <memory>

#include "drivers/bus/cdr.hpp"
#include "drivers/bus/schema.hpp"
#include "drivers/record/tape.hpp"

namespace drydock::record {

/// One topic of a recording: an outlet as drivers/bus/outlets.hpp wants it.
template <class Message>
class Track {
 public:
  /// `topic` as DDS has it, `rt/...`.
  Track(Tape& tape, bus::CdrEncoder& encoder, const std::string& topic, const std::string& frame)
      : tape_(&tape), encoder_(&encoder), message_(new Message{}) {
    const auto& type = bus::message_type<Message>;
    mcap::Map metadata{{"offered_qos_profiles", qos}};
    if (!type.hash.empty()) metadata.emplace_back("topic_type_hash", type.hash);
    channel_ = tape.add_channel(topic.substr(2), bus::ros2_type(type.descriptor->m_typename),
                                std::move(metadata));
    message_->header.frame_id = dds_string_dup(frame.c_str());
  }

  Message& message() { return *message_; }
  void write(Stamp at) { tape_->add(channel_, at, encoder_->encode(*message_)); }

 private:
  /// As rosbag2 writes it: reliable, volatile, keep the last ten.
  static constexpr const char* qos =
      "- history: 1\n  depth: 10\n  reliability: 1\n  durability: 2\n";
  struct Release {
    void operator()(Message* message) const {
      dds_sample_free(message, bus::message_type<Message>.descriptor, DDS_FREE_CONTENTS);
      delete message;
    }
  };

  Tape* tape_;
  bus::CdrEncoder* encoder_;
  std::unique_ptr<Message, Release> message_;
  std::uint16_t channel_ = 0;
};

}  // namespace drydock::record
