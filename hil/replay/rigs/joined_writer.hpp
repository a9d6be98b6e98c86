#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "hil/replay/rigs/file_times.hpp"

namespace drydock::replay {

/// One of the captures that are joined.
struct FilePart {
  std::string file;
  FileTimes times;
  measurement::Stamp begin{};  ///< that decides its place
};

/// What was done with a capture that begins before another ends.
struct Written {
  bool skips = false;          ///< what both have was left out
  std::uint64_t left_out = 0;  ///< of these: messages, frames
  std::string_view what = {};
  std::string damage = {};  ///< of its frames; empty: none
};

/// Writes captures of one sensor behind each other: frames as candump has them, bytes without times
/// as they are on the line; lines and packets that have their times are copied.
class JoinedWriter {
 public:
  /// All of them, in their order; they must outlive this.
  JoinedWriter(const std::string& path, const std::vector<FilePart>& parts,
               const decode::ReplayOptions& how);

  /// `after`: what came until then is there already. Throws std::runtime_error with one line if it
  /// cannot be read or does not fit to the one before.
  Written add(const FilePart& part, std::optional<measurement::Stamp> after);
  /// The format of the file; empty: its content tells it. Throws std::runtime_error if it could not
  /// be written.
  std::string finish();

 private:
  Written add_frames(const FilePart& part, std::optional<measurement::Stamp> after);
  Written add_bytes(const FilePart& part, std::optional<measurement::Stamp> after);
  Written copy(const FilePart& part);

  std::ofstream out_;
  const decode::ReplayOptions& how_;
  bool frames_ = false, copies_ = false;
  std::optional<std::string> head_;        ///< of the first copied file of packets
  std::chrono::nanoseconds frames_end_{};  ///< of captures whose times count from their start
};

}  // namespace drydock::replay
