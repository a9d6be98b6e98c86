#include <fmt/format.h>

#include <algorithm>

#include "drivers/diagnosis/finding_words.hpp"
#include "drivers/monitor/screen/device_lines.hpp"
#include "drivers/monitor/screen/panes.hpp"
#include "drivers/monitor/values/display_units.hpp"

namespace drydock::monitor {
namespace {

std::string ms_text(std::optional<double> s) {
  return s ? fmt::format("{:.1f} ms", *s * 1e3) : std::string("-");
}

void add_troubles(std::vector<PaneLine>& lines, const DeviceView& d, double now_s,
                  std::size_t width) {
  if (d.finding)
    add_wrapped(lines,
                "found " + diagnosis::line_of(
                               *d.finding, fmt::format("for {:.0f} s", now_s - d.finding->since_s)),
                width, Style::wrong);
  if (!d.streaming) add_wrapped(lines, d.status, width, style_of(d));
  if (!d.hint.empty()) add_wrapped(lines, d.hint, width, Style::wrong);
  if (!d.shared_with.empty())
    add_wrapped(lines, "each reads a part of the bytes: also open in " + d.shared_with, width,
                Style::wrong);
  if (!d.last_error.empty() && (d.streaming || d.last_error != d.status))
    add_wrapped(lines, "last error: " + d.last_error, width);
  if (!d.link_note.empty()) add_wrapped(lines, "link: " + d.link_note, width);
  if (!d.told.empty()) add_wrapped(lines, "was told: " + d.told, width);
}

/// As many columns as the widest value allows.
void add_values(std::vector<PaneLine>& lines, const ScreenState& state, std::size_t width) {
  const auto values = chosen_values(state);
  std::size_t names = 0, texts = 0;
  for (const auto* value : values) {
    names = std::max(names, cells_of(value->name));
    texts = std::max(texts, cells_of(value->full()));
  }
  const std::size_t cell = 2 + names + 1 + texts + 1;
  const std::size_t columns = std::max<std::size_t>(1, width / cell);
  const std::size_t rows = (values.size() + columns - 1) / columns;
  for (std::size_t row = 0; row < rows; ++row) {
    PaneLine line;
    for (std::size_t i = row; i < values.size(); i += rows) {
      const bool chosen = i == state.choice.item;
      line.push_back({chosen ? "> " : "  ", chosen ? Style::chosen : Style::plain});
      line.push_back({padded(values[i]->name, names + 1), chosen ? Style::chosen : Style::dim});
      line.push_back({padded(values[i]->full(), texts + 1),
                      values[i]->older_s > 2 ? Style::waiting : Style::plain});
    }
    lines.push_back(std::move(line));
  }
  if (values.empty())
    lines.push_back({{state.choice.filter.empty() ? "no value yet" : "no value has this text"}});
}

std::string times_text(const DeviceView& d) {
  if (!d.received_at_s) return {};
  std::string text =
      fmt::format("arrived {}  valid at {}  latency {}", clock_text(*d.received_at_s),
                  clock_text(*d.valid_at_s), ms_text(d.latency_s));
  if (d.device_time_s) text += "  device time " + device_clock_text(*d.device_time_s);
  return text;
}

std::string counts_text(const DeviceView& d) {
  return fmt::format(
      "{} messages, {} good frames, {} bad; {} B, {} B skipped; {} values refused; "
      "jitter {}, longest gap {}; opened again {} times",
      d.messages, d.frames, d.bad_checksums, d.bytes_in, d.bytes_skipped, d.refused,
      ms_text(d.jitter_s), ms_text(d.longest_interval_s), d.reopens);
}

std::string bus_line(const DeviceView& d) {
  std::string text;
  if (d.bits_per_second) text += fmt::format("bus {:.1f} kbit/s", *d.bits_per_second / 1e3);
  if (d.bus_load) text += fmt::format(" = load {:.1f} %", 100 * *d.bus_load);
  if (!d.can_state.empty()) text += "  controller " + d.can_state;
  if (!text.empty())
    text += fmt::format("  {} error frames  {} lost", d.error_frames, d.can_dropped);
  return text;
}

}  // namespace

std::vector<PaneLine> values_pane(const ScreenState& state, std::size_t width) {
  std::vector<PaneLine> lines;
  const DeviceView& d = state.devices[state.choice.device];
  add_troubles(lines, d, state.now_s, width);
  add_values(lines, state, width);
  for (auto& text : {times_text(d), counts_text(d), bus_line(d),
                     fmt::format("{} {} on {}", d.kind, d.protocol, d.link)})
    if (!text.empty()) add_wrapped(lines, text, width, Style::dim);
  return lines;
}

}  // namespace drydock::monitor
