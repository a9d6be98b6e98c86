#include "drivers/monitor/screen/device_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace drydock::monitor {
namespace {

std::string in_ms(std::optional<double> s) {
  return s ? fmt::format("{:.1f} ms", *s * 1e3) : std::string("-");
}

std::string rate_text(const DeviceView& device) {
  if (device.nominal_rate_hz == 0 && device.rate_hz == 0) return "-";  // a wire without a driver
  return fmt::format("{:6.2f} of {:5.1f}", device.rate_hz, device.nominal_rate_hz);
}

std::string age_text(const DeviceView& device) {
  if (!device.age_s) return "-";
  return *device.age_s < 100 ? fmt::format("{:.2f} s", *device.age_s)
                             : fmt::format("{:.0f} s", *device.age_s);
}

/// One column of the table; a narrow screen leaves out those that need more width.
struct DeviceColumn {
  std::string_view head;
  std::size_t width;
  std::size_t from_width;  ///< columns of the screen
  bool right;              ///< the text stands at the right
  std::string (*text)(const DeviceView&);
};

const std::array device_columns{
    DeviceColumn{"device", 12, 0, false, [](const DeviceView& d) { return d.name; }},
    DeviceColumn{"state", 11, 0, false, [](const DeviceView& d) { return d.state; }},
    DeviceColumn{"Hz", 15, 0, true, rate_text},
    DeviceColumn{"bad", 6, 0, true,
                 [](const DeviceView& d) { return fmt::format("{}", d.bad_checksums); }},
    DeviceColumn{"age", 8, 0, true, age_text},
    DeviceColumn{"jitter", 10, 110, true, [](const DeviceView& d) { return in_ms(d.jitter_s); }},
    DeviceColumn{"B skipped", 10, 120, true,
                 [](const DeviceView& d) { return fmt::format("{}", d.bytes_skipped); }},
    DeviceColumn{"messages", 10, 130, true,
                 [](const DeviceView& d) { return fmt::format("{}", d.messages); }},
};
constexpr std::size_t narrowest_words = 10;

/// What a person should know first about a device. Bytes that another program takes explain all
/// else: they look like damage or a wrong rate.
std::string first_words(const DeviceView& device) {
  if (!device.shared_with.empty()) return "also open in " + device.shared_with;
  if (!device.hint.empty()) return device.hint;
  if (device.finding) return device.finding->cause + ": " + device.finding->meaning;
  if (!device.streaming) return device.status;
  return device.kind + ' ' + device.protocol;
}

std::size_t put_column(Canvas& canvas, std::size_t row, std::size_t at, const DeviceColumn& column,
                       std::string text, Style style) {
  if (text.size() > column.width) text.resize(column.width);
  const std::size_t blanks = column.right ? column.width - text.size() : 0;
  canvas.put(row, at + blanks, text, style);
  return at + column.width + 1;
}

void draw_heads(Canvas& canvas, std::size_t row) {
  std::size_t at = 2;
  for (const auto& column : device_columns)
    if (canvas.width() >= column.from_width)
      at = put_column(canvas, row, at, column, std::string(column.head), Style::heading);
  if (canvas.width() >= at + 1 + narrowest_words) canvas.put(row, at + 1, "what", Style::heading);
}

void draw_device(Canvas& canvas, std::size_t row, const DeviceView& device, bool chosen) {
  canvas.put(row, 0, chosen ? ">" : " ");
  std::size_t at = 2;
  for (const auto& column : device_columns) {
    if (canvas.width() < column.from_width) continue;
    const bool is_state = column.head == "state";
    at = put_column(canvas, row, at, column, column.text(device),
                    is_state ? style_of(device) : Style::plain);
  }
  if (canvas.width() >= at + 1 + narrowest_words)
    canvas.put(row, at + 1, first_words(device), device.finding ? Style::wrong : Style::plain);
  if (chosen)
    for (std::size_t i = 0; i < 2 + std::min(device.name.size(), device_columns[0].width); ++i)
      canvas.put(row, i, std::string_view(i < 2 ? "> " + i : device.name.data() + i - 2, 1),
                 Style::chosen);
}

}  // namespace

Style style_of(const DeviceView& device) {
  if (device.streaming) return Style::good;
  return device.state == "stale" ? Style::waiting : Style::wrong;
}

std::size_t draw_devices(Canvas& canvas, const ScreenState& state, std::size_t row,
                         std::size_t most) {
  draw_heads(canvas, row++);
  const std::size_t count = std::min(most, state.devices.size());
  const std::size_t chosen = state.choice.device;
  const std::size_t first = chosen < count ? 0 : chosen - count + 1;
  for (std::size_t i = first; i < first + count; ++i)
    draw_device(canvas, row++, state.devices[i], i == chosen);
  return row;
}

}  // namespace drydock::monitor
