#pragma once

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/frame_capture.hpp"

namespace drydock::capture {

/// The frames of a CAN capture in a file, read block by block as they are asked for.
class CaptureFile {
 public:
  /// `format` empty: recognised by content. `interface` empty: all of them.
  CaptureFile(const std::string& file, std::string_view format, std::string interface);

  std::optional<Record> next();  ///< empty at the end, or when it cannot be read
  /// Why there is no frame to be had: the file cannot be read, or is in no format that we know.
  /// Empty when there is no such reason; settled by the first next().
  std::string trouble() const;
  const FrameCapture& frames() const { return frames_; }

 private:
  std::string file_;
  std::string interface_;
  FileBlocks blocks_;
  FrameCapture frames_;
  bool at_end_ = false;
};

}  // namespace drydock::capture
