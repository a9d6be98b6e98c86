#pragma once

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/frame_capture.hpp"
#include "drivers/capture/steady_times.hpp"

namespace drydock::capture {

/// The frames of a CAN capture in a file. It reads the file block by block, on demand. Their times
/// go on where the recording's clock was set back.
class CaptureFile {
 public:
  /// An empty `format`: recognised by content. An empty `interface`: all interfaces.
  CaptureFile(const std::string& file, std::string_view format, std::string interface);

  std::optional<Record> next();  ///< empty at the end, or if the file cannot be read
  /// Why there are no frames: the file cannot be read, or its format is not known. Empty if there
  /// is no such reason. The first next() decides it.
  std::string trouble() const;
  const FrameCapture& frames() const { return frames_; }
  /// Of what was read so far, whatever its interface.
  const SteadyTimes& times() const { return times_; }

 private:
  std::string file_;
  std::string interface_;
  FileBlocks blocks_;
  FrameCapture frames_;
  SteadyTimes times_;
  bool at_end_ = false;
};

}  // namespace drydock::capture
