#pragma once

#include <fstream>
#include <memory>
#include <vector>

#include "drivers/capture/line_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"

namespace drydock::shell {

/// A recording of raw bytes (`file:` link) in the lockstep shell. It omits the comments of the
/// head. The bytes reach the driver at the line's baud rate, in virtual time; those of a pcapng
/// file at their own times. At the end of the file the line falls silent.
class RecordedLine final : public Actor {
 public:
  /// Throws std::runtime_error with one line if the file cannot be opened, or has several
  /// lines.
  RecordedLine(const link::Uri& uri, DeviceActor& driver, Stamp start);

  std::optional<Stamp> deadline() const override { return next_; }
  void act(Stamp now) override;

 private:
  void begin_packets(const link::Uri& uri, Stamp start);
  void act_on_packet(Stamp now);

  std::ifstream file_;
  DeviceActor& driver_;
  std::chrono::nanoseconds byte_time_;
  bool raw_;
  capture::CommentHead head_;
  std::unique_ptr<capture::LineFile> packets_;  ///< null: bytes without times
  capture::LineFile::Read read_;                ///< what comes at next_
  Stamp::duration before_{0};                   ///< from the times of the file to those here
  std::vector<char> chunk_;
  std::optional<Stamp> next_;
};

}  // namespace drydock::shell
