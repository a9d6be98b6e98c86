#pragma once

#include <map>
#include <string>

#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/capture/steady_times.hpp"
#include "drivers/recordings/record/background_file.hpp"

namespace drydock::record {

using measurement::Stamp;

/// What to do if the disk is too slow. `lose`: count and go on, because the drivers must not wait.
/// `wait`: for virtual time, which can wait.
enum class WhenBehind : std::uint8_t { lose, wait };

struct TapeStatus {
  std::uint64_t messages = 0;  ///< in the file
  std::uint64_t lost = 0;      ///< not recorded: the disk was too slow or failed
  std::uint64_t bytes = 0;     ///< written, into all files
  std::uint64_t files = 1, deleted = 0;
  boost::system::error_code error;
  std::string failed_file{};  ///< that the error is of; empty without one
};

/// Writes a recording: first channels, then messages. A chunk is written at 768 KiB, or after each
/// second of the messages' time. After a file error it only counts messages as lost. The messages'
/// times in the file go on where the host's clock is set back; their content keeps what it said.
class Tape final : public bus::CdrSink {
 public:
  /// Attachments and metadata are at the start of each file.
  Tape(Parts parts, WhenBehind when_behind, std::vector<mcap::Attachment> attachments = {},
       std::vector<mcap::Metadata> metadata = {});

  /// Call it before begin(). One schema serves all topics of its type.
  std::uint32_t add_topic(const Topic& topic) override;
  bool wanted(std::uint32_t) const override { return true; }
  /// Writes the channels.
  void begin();

  void put(std::uint32_t topic, Stamp at, std::span<const std::uint8_t> cdr) override {
    write(topic, times_.beside(at.time_since_epoch()), cdr);
  }
  /// Of data that came over a link just now: they tell that the clock was set back.
  void put(std::uint32_t topic, std::string_view link, Stamp at,
           std::span<const std::uint8_t> cdr) {
    write(topic, times_.of(link, at.time_since_epoch()), cdr);
  }
  /// Writes messages older than a second, so that they do not wait for more. A clock that was set
  /// back does not make them wait either.
  void tick(Stamp now);
  boost::system::error_code finish();

  TapeStatus status() const;
  const capture::SteadyTimes& times() const { return times_; }

 private:
  void write(std::uint32_t topic, std::chrono::nanoseconds at, std::span<const std::uint8_t> cdr);
  void put_block();

  BackgroundFile file_;
  WhenBehind when_behind_;
  capture::SteadyTimes times_;
  mcap::Block block_;
  std::map<std::string, std::uint16_t> schemas_;  ///< by type
  std::vector<std::uint32_t> sequences_;          ///< by channel, from 1
};

}  // namespace drydock::record
