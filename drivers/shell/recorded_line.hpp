#pragma once

#include <fstream>
#include <vector>

#include "drivers/capture/comment_head.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"

namespace drydock::shell {

/// A recording of raw bytes (`file:` link) in the lockstep shell. It omits the comments of the
/// head. The bytes reach the driver at the line's baud rate, in virtual time. At the end of the
/// file the line falls silent.
class RecordedLine final : public Actor {
 public:
  /// Throws std::runtime_error with one line if the file cannot be opened.
  RecordedLine(const link::Uri& uri, DeviceActor& driver, Stamp start);

  std::optional<Stamp> deadline() const override { return next_; }
  void act(Stamp now) override;

 private:
  std::ifstream file_;
  DeviceActor& driver_;
  std::chrono::nanoseconds byte_time_;
  bool raw_;
  capture::CommentHead head_;
  std::vector<char> chunk_;
  std::optional<Stamp> next_;
};

}  // namespace drydock::shell
