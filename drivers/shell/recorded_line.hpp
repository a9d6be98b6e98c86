#pragma once

#include <memory>
#include <vector>

#include "drivers/capture/byte_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/recording_clock.hpp"

namespace drydock::shell {

/// A recording of bytes (`file:` link) in the lockstep shell. In virtual time each message reaches
/// the drivers when the device's clock says, counted from `start`; without such a clock bytes come
/// at the line's rate, and those of a file with times (pcap, a logger's) at these. At the end of
/// the file the line falls silent, which is no fault of the devices.
class RecordedLine final : public Actor {
 public:
  /// Throws std::runtime_error with one line if the file cannot be opened, or has several lines.
  RecordedLine(const link::Uri& uri, std::vector<DeviceActor*> drivers, Stamp start,
               RecordingClock clock);

  std::optional<Stamp> deadline() const override { return next_; }
  void act(Stamp now) override;
  const RecordingClock& clock() const { return clock_; }
  /// What a person must know of what was read: what is not in the file, a clock that was set.
  std::vector<std::string> notes() const;

 private:
  void begin_packets(const link::Uri& uri);
  void act_on_packet(Stamp now);
  void deliver(wire::Bytes bytes, Stamp now);
  void end(Stamp now);
  Stamp due() const;  ///< of read_
  /// Bytes of the next step: to the end of the message that the device's clock says, else a few.
  std::size_t next_bytes() const;
  void schedule(Stamp now);

  capture::ByteFile file_;
  std::vector<DeviceActor*> drivers_;
  Stamp start_;
  RecordingClock clock_;
  wire::LineRate rate_;      ///< as the URI tells it
  std::size_t message_ = 0;  ///< the next of the device's clock
  std::uint64_t delivered_ = 0;
  std::vector<std::uint8_t> chunk_;
  std::unique_ptr<capture::LineFile> packets_;  ///< null: bytes without times
  capture::LineFile::Read read_{};              ///< what comes at next_
  std::optional<Stamp> next_;
};

}  // namespace drydock::shell
