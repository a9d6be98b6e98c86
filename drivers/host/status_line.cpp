#include "drivers/host/status_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::host {
namespace {

constexpr std::chrono::milliseconds draw_period{500};

}  // namespace

std::string standing_text(const RunStanding& standing, std::size_t width) {
  const auto& s = standing;
  std::string text = s.duration_s > 0
                         ? fmt::format("{:.0f} s of {:.0f} s, {:.0f} s left", s.elapsed_s,
                                       s.duration_s, std::max(0.0, s.duration_s - s.elapsed_s))
                         : fmt::format("{:.0f} s", s.elapsed_s);
  if (s.recorded) text += fmt::format("  {:.1f} MB", static_cast<double>(*s.recorded) / 1e6);
  for (const auto& [name, rate_hz] : s.rates_hz) {
    const auto rate = fmt::format("  {} {:.2f} Hz", name, rate_hz);
    if (text.size() + rate.size() > width) break;  // half a number would be another number
    text += rate;
  }
  if (text.size() > width) text.resize(width);
  return text;
}

StatusLine::StatusLine(Ask ask)
    : ask_(std::move(ask)), terminal_(terminal::erases_lines(STDOUT_FILENO)) {}

void StatusLine::tick(Stamp now) {
  if (!terminal_ || now < next_) return;
  next_ = now + draw_period;
  fmt::print("{}{}", terminal::wipe_line,
             standing_text(ask_(), terminal::screen_size(STDOUT_FILENO).columns - 1));
  std::fflush(stdout);
  drawn_ = true;
}

void StatusLine::wipe() {
  if (!std::exchange(drawn_, false)) return;
  fmt::print("{}", terminal::wipe_line);
  std::fflush(stdout);
}

}  // namespace drydock::host
