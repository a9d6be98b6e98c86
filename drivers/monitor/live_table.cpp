#include "drivers/monitor/live_table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "drivers/link/clock.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::monitor {
namespace {

constexpr std::size_t events_shown = 5;

std::string bar(double part) {
  constexpr int width = 30;
  const int full = std::clamp(static_cast<int>(part * width), 0, width);
  return std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(width - full), '.');
}

/// What matters first stands first: a narrow terminal cuts the rest off.
std::string run_line(const DeviceView& v, const Palette& palette) {
  return fmt::format(
      "{:<10} {} {:>7.2f} Hz of {:>5.1f} {:>5} bad  age {:>7}  {:>9} messages  {:>8} B skipped",
      v.name, palette.state(v.state, fmt::format("{:<11}", v.state)), v.rate_hz, v.nominal_rate_hz,
      v.bad_checksums, v.age_s ? fmt::format("{:.3f} s", *v.age_s) : std::string("-"), v.messages,
      v.bytes_skipped);
}

}  // namespace

LiveTable::LiveTable(const shell::RealTime& shell, Stamp start, double duration_s)
    : shell_(shell),
      start_(start),
      duration_s_(duration_s),
      terminal_(terminal::erases_lines(STDOUT_FILENO)),
      palette_(terminal_),
      screen_(stdout) {}

void LiveTable::on_state(const device::Device& device, const device::Transition& change) {
  note(fmt::format("{}: {} -> {}: {}", device.name(), to_string(change.from), to_string(change.to),
                   change.why.view()));
}

void LiveTable::note(std::string line) {
  if (!terminal_) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
    return;
  }
  events_.push_back(std::move(line));
  if (events_.size() > events_shown) events_.pop_front();
}

void LiveTable::tick(Stamp) {
  const double elapsed_s = measurement::seconds(link::steady_now() - start_);
  if (terminal_) {
    draw_table(elapsed_s);
  } else if (elapsed_s >= next_lines_s_) {
    next_lines_s_ += 10;
    print_lines(elapsed_s);
  }
}

void LiveTable::draw_table(double elapsed_s) {
  std::vector<std::string> lines;
  if (duration_s_ > 0) {
    lines.push_back(
        fmt::format("[{}] {:.0f} s of {:.0f} s, {:.0f} s left, Ctrl-C ends with the "
                    "report",
                    bar(elapsed_s / duration_s_), elapsed_s, duration_s_,
                    std::max(0.0, duration_s_ - elapsed_s)));
  } else {
    lines.push_back(fmt::format("{:.0f} s, Ctrl-C ends with the report", elapsed_s));
  }
  for (std::size_t i = 0; i < shell_.size(); ++i)
    lines.push_back(run_line(view_of(shell_.device(i), shell_.health(i)), palette_));
  for (const auto& event : events_) lines.push_back("  " + event);
  screen_.draw(std::move(lines));
}

void LiveTable::print_lines(double elapsed_s) const {
  for (std::size_t i = 0; i < shell_.size(); ++i) {
    const auto h = shell_.health(i);
    fmt::print("{:.0f} s {}: {}, {:.2f} Hz of {:.1f}, {} messages, {} bad checksums\n", elapsed_s,
               shell_.device(i).name(), to_string(h.state), h.rate_hz.value_or(0),
               h.nominal_rate_hz, h.messages, h.stream.bad_checksums);
  }
  std::fflush(stdout);
}

void LiveTable::finish() { screen_.finish(); }

}  // namespace drydock::monitor
