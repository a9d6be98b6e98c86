#pragma once

#include <span>

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/record/tape.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::record {

/// A link whose bytes or frames are recorded: `/raw/serial/<name>` or `/raw/can/<name>`.
struct RecordedLink {
  std::string uri;  ///< as in the rig file
  std::string name;
  bool frames = false;               ///< a CAN bus
  std::vector<std::string> devices;  ///< names of the devices on the link
};

/// The content of a recording. Topics are those of docs/build/bus.md, without `rt`.
struct RecorderOptions {
  std::vector<RecordedLink> links;
  std::vector<bus::Device> devices;                 ///< by `Origin::device`
  std::vector<std::string> estimators, navigators;  ///< navigators give Navigation too
  std::vector<bus::InnovationSource> innovations;
  mcap::Map versions;                         ///< of the programs, as metadata
  std::vector<mcap::Attachment> attachments;  ///< the rig file and the files that it names
  WhenBehind when_behind = WhenBehind::lose;
};

/// Records every byte and frame in both directions, and the decoded messages. It never waits
/// (unless told to) and never throws after construction. One thread at a time.
class Recorder final : public shell::RawListener {
 public:
  Recorder(Parts parts, const RecorderOptions& options);
  Recorder(mcap::Sink sink, const RecorderOptions& options)
      : Recorder(Parts{{std::move(sink)}}, options) {}

  void on_bytes(std::string_view link, shell::Direction direction, wire::Bytes bytes,
                Stamp at) override;
  void on_frame(std::string_view link, shell::Direction direction, const wire::CanFrame& frame,
                Stamp at) override;
  /// Receives decoded measurements and the results from them.
  bus::CdrPublisher& topics() { return topics_; }

  void tick(Stamp now);
  boost::system::error_code finish();
  TapeStatus status() const;
  /// As capture::SteadyTimes::in_words().
  std::string clock_note() const { return tape_.times().in_words(); }

 private:
  struct Link {
    std::string uri;
    std::uint32_t topic;
  };
  void add_raw(std::string_view link, Stamp at);

  Tape tape_;
  std::vector<Link> links_;
  std::vector<std::uint8_t> raw_;  ///< reused for each message
  bus::CdrPublisher topics_;
};

}  // namespace drydock::record
