#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::replay {

/// Shows a bar for long work on one file if `out` is a terminal; else shows nothing. Ctrl-C ends
/// the work cleanly.
class RecordingProgress {
 public:
  RecordingProgress(std::string what, std::FILE* out);
  ~RecordingProgress();
  RecordingProgress(const RecordingProgress&) = delete;
  RecordingProgress& operator=(const RecordingProgress&) = delete;

  /// Matches record::Watch: returns false after Ctrl-C.
  bool operator()(double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::FILE* out_;
  bool terminal_, drawn_ = false;
  unsigned calls_ = 0;
  Clock::time_point next_drawing_;
  terminal::InterruptFlag interrupt_;
};

}  // namespace drydock::replay
