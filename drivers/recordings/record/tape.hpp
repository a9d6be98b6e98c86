#pragma once

#include <map>
#include <string>

#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/recordings/record/background_file.hpp"

namespace drydock::record {

using measurement::Stamp;

/// What to do when the disk does not keep up. `lose`: count and go on, the drivers must not wait.
/// `wait`: for virtual time, which has none to lose.
enum class WhenBehind : std::uint8_t { lose, wait };

struct TapeStatus {
  std::uint64_t messages = 0;  ///< in the file
  std::uint64_t lost = 0;      ///< not recorded: disk too slow, or failed
  std::uint64_t bytes = 0;     ///< of the file, by now
  boost::system::error_code error;
};

/// A recording in the making: channels, then messages. A chunk goes out at 768 KiB or each second
/// of the messages' time. After a file error messages are counted as lost, nothing else happens.
class Tape final : public bus::CdrSink {
 public:
  /// Attachments and metadata stand at the file's start.
  Tape(mcap::Sink sink, WhenBehind when_behind,
       const std::vector<mcap::Attachment>& attachments = {},
       const std::vector<mcap::Metadata>& metadata = {});

  /// Before begin(). One schema serves all topics of its type.
  std::uint32_t add_topic(const Topic& topic) override;
  bool wanted(std::uint32_t) const override { return true; }
  /// Puts the channels out.
  void begin();

  void put(std::uint32_t topic, Stamp at, std::span<const std::uint8_t> cdr) override;
  /// Puts out what is older than a second, so that silence does not keep it back.
  void tick(Stamp now);
  boost::system::error_code finish();

  TapeStatus status() const;

 private:
  void put_block();

  BackgroundFile file_;
  WhenBehind when_behind_;
  mcap::Block block_;
  std::map<std::string, std::uint16_t> schemas_;  ///< by type
  std::vector<std::uint32_t> sequences_;          ///< by channel, from 1
  std::uint64_t lost_ = 0;                        ///< for want of room
};

}  // namespace drydock::record
