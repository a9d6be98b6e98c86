#pragma once

#include <chrono>
#include <memory>

#include "drivers/bus/endpoint.hpp"
#include "drivers/bus/publisher.hpp"

/// The parts of a publisher. Only publisher.cpp includes this file.
namespace drydock::bus {

/// Readers acknowledge about every 100 ms. They can ask again only for samples that the writer
/// still keeps. Therefore this is deeper than ROS 2's ten: one second of a 200 Hz IMU. DDS does not
/// require equal depths.
inline constexpr std::int32_t writer_depth = 200;

/// One topic, its writer, and one message that is reused for every sample.
template <class Message>
class Writer {
 public:
  Writer(const Participant& participant, const std::string& topic, const std::string& frame,
         std::string_view provenance = {})
      : topic_(make_topic<Message>(participant.handle(), topic)),
        writer_(dds_create_writer(participant.handle(), topic_.handle(),
                                  make_qos(writer_depth, 0, user_data<Message>(provenance)).get(),
                                  nullptr),
                "writer of " + topic),
        message_(new Message{}) {
    message_->header.frame_id = dds_string_dup(frame.c_str());
    counters_.topic = topic;
  }

  Message& message() { return *message_; }

  /// `source_time` is `received_at` and becomes the DDS source timestamp. Thus it reaches
  /// subscribers of any message type.
  void write(Stamp source_time) {
    const auto code =
        dds_write_ts(writer_.handle(), message_.get(), source_time.time_since_epoch().count());
    ++(code == DDS_RETCODE_OK        ? counters_.written
       : code == DDS_RETCODE_TIMEOUT ? counters_.dropped
                                     : counters_.failed);
    if (dds_wait_for_acks(writer_.handle(), 0) == DDS_RETCODE_OK) {
      acknowledged_ = counters_.written;
    } else if (counters_.written - acknowledged_ > writer_depth) {
      ++counters_.overrun;
    }
  }

  const TopicCounters& counters() const { return counters_; }

  /// False: after `longest` a reader still owes an acknowledgement.
  bool wait_for_readers(std::chrono::nanoseconds longest) const {
    return dds_wait_for_acks(writer_.handle(), longest.count()) == DDS_RETCODE_OK;
  }

  std::size_t matched() const {
    dds_publication_matched_status_t status{};
    dds_get_publication_matched_status(writer_.handle(), &status);
    return status.current_count;
  }

 private:
  struct Release {
    void operator()(Message* message) const {
      dds_sample_free(message, message_type<Message>.descriptor, DDS_FREE_CONTENTS);
      delete message;
    }
  };

  Entity topic_, writer_;
  std::unique_ptr<Message, Release> message_;
  TopicCounters counters_;
  std::uint64_t acknowledged_ = 0;  ///< of counters_.written: all readers acknowledged these
};

}  // namespace drydock::bus
