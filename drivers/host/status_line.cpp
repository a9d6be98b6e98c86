#include "drivers/host/status_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::host {
namespace {

constexpr std::chrono::milliseconds draw_period{500};

}  // namespace

std::vector<std::string> rate_words(const RunStanding& standing) {
  std::vector<std::string> words;
  for (const auto& [name, rate_hz] : standing.rates_hz)
    words.push_back(fmt::format("{} {:.2f} Hz", name, rate_hz));
  return words;
}

std::vector<std::string> standing_lines(const RunStanding& standing, std::size_t width) {
  const auto& s = standing;
  std::string first = s.duration_s > 0
                          ? fmt::format("{:.0f} s of {:.0f} s, {:.0f} s left", s.elapsed_s,
                                        s.duration_s, std::max(0.0, s.duration_s - s.elapsed_s))
                          : fmt::format("{:.0f} s", s.elapsed_s);
  if (s.recorded) first += fmt::format("  {:.1f} MB", static_cast<double>(*s.recorded) / 1e6);
  return in_lines(std::move(first), rate_words(s), width);
}

StatusLine::StatusLine(Ask ask)
    : ask_(std::move(ask)), terminal_(terminal::erases_lines(STDOUT_FILENO)) {}

void StatusLine::tick(Stamp now) {
  if (!terminal_ || now < next_) return;
  next_ = now + draw_period;
  lines_.draw(standing_lines(ask_(), terminal::screen_size(STDOUT_FILENO).columns - 1));
}

}  // namespace drydock::host
