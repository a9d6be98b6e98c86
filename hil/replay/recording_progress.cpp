#include "hil/replay/recording_progress.hpp"

#include <fmt/format.h>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::replay {

namespace {
constexpr std::chrono::milliseconds not_worth_a_bar{500}, between_drawings{100};
}  // namespace

RecordingProgress::RecordingProgress(std::string what, std::FILE* out)
    : what_(std::move(what)),
      out_(out),
      terminal_(terminal::erases_lines(fileno(out))),
      next_drawing_(Clock::now() + not_worth_a_bar) {}

RecordingProgress::~RecordingProgress() {
  if (!drawn_) return;
  fmt::print(out_, "{}", terminal::wipe_line);
  std::fflush(out_);
}

bool RecordingProgress::operator()(double done) {
  constexpr unsigned between_looks = 64;  // reading the clock for every message would cost too much
  if (terminal_ && calls_++ % between_looks == 0 && Clock::now() >= next_drawing_) {
    fmt::print(out_, "{}{} {} {:.0f} %, Ctrl-C ends", terminal::wipe_line, what_,
               terminal::progress_bar(done), 100 * done);
    std::fflush(out_);
    drawn_ = true;
    next_drawing_ = Clock::now() + between_drawings;
  }
  return !interrupt_.set();
}

}  // namespace drydock::replay
