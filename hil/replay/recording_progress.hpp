#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "drivers/host/status_line.hpp"
#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::replay {

/// "replay [####....] 40 %, 12 s, 18 s left  2.3 MB  dvl 5.00 Hz": what is done of long work on one
/// file, how long it took and will take, what was written, and the rates of `standing`.
std::vector<std::string> progress_lines(const std::string& what, double done,
                                        const host::RunStanding& standing, std::size_t width);

/// Shows these lines for long work on one file if `out` is a terminal; else shows nothing. Ctrl-C
/// ends the work cleanly.
class RecordingProgress {
 public:
  using Ask = std::function<host::RunStanding()>;
  /// `ask`: the size and rates that it shows too; may be empty.
  RecordingProgress(std::string what, std::FILE* out, Ask ask = {});
  ~RecordingProgress();
  RecordingProgress(const RecordingProgress&) = delete;
  RecordingProgress& operator=(const RecordingProgress&) = delete;

  /// Matches record::Watch: returns false after Ctrl-C.
  bool operator()(double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::FILE* out_;
  Ask ask_;
  bool terminal_;
  unsigned calls_ = 0;
  Clock::time_point begun_, next_drawing_;
  host::RedrawnLines lines_;
  terminal::InterruptFlag interrupt_;
};

}  // namespace drydock::replay
