#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/capture/frame_capture.hpp"
#include "hil/info/line_info.hpp"

namespace drydock::info {

/// What is in a capture of CAN frames. Times go on where the recording's clock was set back.
struct CaptureInfo {
  std::string file, format, damage, note;               ///< note: how its times were read
  std::uint64_t size = 0, frames = 0;                   ///< [bytes], all interfaces
  std::optional<std::chrono::nanoseconds> first, last;  ///< last: the latest
  std::chrono::nanoseconds longest{0};                  ///< between two frames
  std::uint64_t behind = 0;  ///< frames whose time in the file is before an earlier frame's
  std::chrono::nanoseconds most_behind{0};  ///< and by how much at most: the host's clock was set
  std::map<std::string, std::uint64_t> interfaces;  ///< frames of each
  std::map<std::uint32_t, std::uint64_t> identifiers;

  double duration_s() const;  ///< 0: the format has no times
};

/// Reads the whole file. Empty: it is no CAN capture of a known format.
std::optional<CaptureInfo> capture_info(const std::string& file);

std::string to_text(const CaptureInfo& info);
/// `lines`: of bytes, in the same file.
std::string to_json(const CaptureInfo& info, const std::vector<LineInfo>& lines);

}  // namespace drydock::info
