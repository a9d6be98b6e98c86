#include "hil/replay/recording_progress.hpp"

#include <fmt/format.h>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::replay {

namespace {
constexpr std::chrono::milliseconds not_worth_a_bar{500}, between_drawings{200};
}  // namespace

std::vector<std::string> progress_lines(const std::string& what, double done,
                                        const host::RunStanding& standing, std::size_t width) {
  std::string first = fmt::format("{} {} {:.0f} %, {:.0f} s", what, terminal::progress_bar(done),
                                  100 * done, standing.elapsed_s);
  if (done > 0) first += fmt::format(", {:.0f} s left", standing.elapsed_s * (1 - done) / done);
  auto parts = host::rate_words(standing);
  if (standing.recorded)
    parts.insert(parts.begin(),
                 fmt::format("{:.1f} MB", static_cast<double>(*standing.recorded) / 1e6));
  parts.push_back("Ctrl-C ends");
  return host::in_lines(std::move(first), parts, width);
}

RecordingProgress::RecordingProgress(std::string what, std::FILE* out, Ask ask)
    : what_(std::move(what)),
      out_(out),
      ask_(std::move(ask)),
      terminal_(terminal::erases_lines(fileno(out))),
      begun_(Clock::now()),
      next_drawing_(begun_ + not_worth_a_bar),
      lines_(out) {}

RecordingProgress::~RecordingProgress() { lines_.wipe(); }

bool RecordingProgress::operator()(double done) {
  constexpr unsigned between_looks = 16;  // reading the clock for every message would cost too much
  if (terminal_ && calls_++ % between_looks == 0 && Clock::now() >= next_drawing_) {
    auto standing = ask_ ? ask_() : host::RunStanding{};
    standing.elapsed_s = std::chrono::duration<double>(Clock::now() - begun_).count();
    const auto width = terminal::screen_size(fileno(out_)).columns - 1;
    lines_.draw(progress_lines(what_, done, standing, width));
    next_drawing_ = Clock::now() + between_drawings;
  }
  return !interrupt_.set();
}

}  // namespace drydock::replay
