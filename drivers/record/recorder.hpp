#pragma once

#include <memory>
#include <span>

#include "drivers/bus/device.hpp"
#include "drivers/mcap/file_sink.hpp"
#include "drivers/record/tape.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::record {

/// A link whose bytes or frames are recorded: `/raw/serial/<name>` or `/raw/can/<name>`.
struct RecordedLink {
  std::string uri;  ///< as the rig file has it
  std::string name;
  bool frames = false;               ///< a CAN bus
  std::vector<std::string> devices;  ///< on it
};

/// What a recording holds. Topics are those of docs/bus.md, without `rt`.
struct RecorderOptions {
  std::vector<RecordedLink> links;
  std::vector<bus::Device> devices;  ///< by `Origin::device`
  std::vector<std::string> estimators;
  mcap::Map versions;                         ///< of the programs, as metadata
  std::vector<mcap::Attachment> attachments;  ///< the rig file and what it names
  WhenBehind when_behind = WhenBehind::lose;
};

/// Records every byte and frame in both directions, and what was understood of them. Never waits
/// (unless told), never throws after construction. One thread at a time.
class Recorder final : public shell::RawListener {
 public:
  Recorder(mcap::Sink sink, const RecorderOptions& options);
  ~Recorder() override;

  void on_bytes(std::string_view link, shell::Direction direction, wire::Bytes bytes,
                Stamp at) override;
  void on_frame(std::string_view link, shell::Direction direction, const wire::CanFrame& frame,
                Stamp at) override;
  void note(const measurement::Measurement& measurement);
  void note(const bus::Attitude& attitude, std::size_t estimator);
  void note(std::span<const bus::DeviceStatus> health, Stamp now);

  void tick(Stamp now);
  boost::system::error_code finish();
  TapeStatus status() const;

 private:
  struct Tracks;
  struct Link {
    std::string uri;
    std::uint16_t channel;
  };
  void add_raw(std::string_view link, Stamp at);

  Tape tape_;
  std::vector<Link> links_;
  std::vector<std::uint8_t> raw_;  ///< used again for each
  std::unique_ptr<Tracks> tracks_;
};

}  // namespace drydock::record
