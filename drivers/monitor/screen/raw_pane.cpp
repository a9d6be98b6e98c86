#include <fmt/format.h>

#include <algorithm>

#include "drivers/monitor/screen/panes.hpp"

namespace drydock::monitor {
namespace {

constexpr std::size_t narrow_row = 8, wide_row = 16, wide_from = 100;
constexpr std::size_t letters_from = 72;  // a narrower screen has no room for them
constexpr std::size_t list_bytes = 8;     // of a frame in the list of frames

void add_bytes(PaneLine& line, const ShownFrame& frame, std::size_t from, std::size_t count) {
  for (std::size_t i = from; i < from + count; ++i) {
    const bool there = i < frame.bytes.size();
    const bool changed = there && i < frame.changed.size() && frame.changed[i];
    line.push_back({there ? fmt::format("{:02X}", frame.bytes[i]) : "  ",
                    changed ? Style::changed : Style::plain});
    line.push_back({" "});
  }
}

std::string letters(const ShownFrame& frame, std::size_t from, std::size_t count) {
  std::string text;
  for (std::size_t i = from; i < std::min(from + count, frame.bytes.size()); ++i)
    text +=
        frame.bytes[i] >= 0x20 && frame.bytes[i] < 0x7F ? static_cast<char>(frame.bytes[i]) : '.';
  return padded(text, count);
}

PaneLine listed(const ShownFrame& frame, std::size_t names, bool chosen) {
  const Style style = chosen ? Style::chosen : Style::plain;
  PaneLine line{{chosen ? "> " : "  ", style},
                {padded(frame.name, names), style},
                {fmt::format(" {:>8} {:>7.2f} Hz {:>4} B  ", frame.count, frame.rate_hz,
                             frame.bytes.size())}};
  add_bytes(line, frame, 0, std::min(list_bytes, frame.bytes.size()));
  if (frame.bytes.size() > list_bytes) line.push_back({"..."});
  return line;
}

/// Rows of hex at the left, one field beside each row.
void add_dump(std::vector<PaneLine>& lines, const ShownFrame& frame, std::size_t width) {
  const std::size_t bytes = width >= wide_from ? wide_row : narrow_row;
  const std::size_t rows = (frame.bytes.size() + bytes - 1) / bytes;
  for (std::size_t row = 0; row < std::max(rows, frame.fields.size()); ++row) {
    PaneLine line;
    const std::size_t from = row * bytes;
    line.push_back({row < rows ? fmt::format("{:04X}  ", from) : "      ", Style::dim});
    add_bytes(line, frame, from, bytes);
    if (width >= letters_from) line.push_back({letters(frame, from, bytes) + "  ", Style::dim});
    if (row < frame.fields.size()) {
      line.push_back({frame.fields[row].name + ' ', Style::dim});
      line.push_back({frame.fields[row].text});
    }
    lines.push_back(std::move(line));
  }
}

std::string count_line(const ScreenState& state, std::size_t shown) {
  std::string text = fmt::format("{} of {} kinds of frames", shown, state.wire.frames.size());
  if (state.wire.not_listed > 0)
    text += fmt::format(", {} frames of other kinds not listed", state.wire.not_listed);
  return text;
}

}  // namespace

std::vector<PaneLine> raw_pane(const ScreenState& state, std::size_t width, std::size_t height) {
  if (!state.no_wire.empty()) return {{{state.no_wire}}};
  const auto frames = chosen_frames(state);
  std::vector<PaneLine> lines{{{count_line(state, frames.size()), Style::heading}}};
  if (frames.empty()) return lines;
  std::size_t names = 8;
  for (const auto* frame : frames) names = std::max(names, cells_of(frame->name));
  const std::size_t chosen = std::min(state.choice.item, frames.size() - 1);
  const std::size_t most = std::max<std::size_t>(3, height / 2);
  const std::size_t count = std::min(most, frames.size());
  const std::size_t first = chosen < count ? 0 : chosen - count + 1;
  for (std::size_t i = first; i < first + count; ++i)
    lines.push_back(listed(*frames[i], names, i == chosen));
  add_dump(lines, *frames[chosen], width);
  return lines;
}

}  // namespace drydock::monitor
