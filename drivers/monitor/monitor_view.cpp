#include "drivers/monitor/monitor_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "drivers/diagnosis/finding_words.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/cut_row.hpp"
#include "drivers/monitor/problems.hpp"
#include "drivers/terminal/terminal_screen.hpp"
#include "drivers/text/json_lines.hpp"

namespace drydock::monitor {

template <class F>
void visit_fields(const ShownValue& v, F&& field) {
  field("name", v.name);
  field("text", v.text);
  field("unit", v.unit);
  field("older_s", v.older_s);
}

template <class F>
void visit_fields(const DeviceView& v, F&& field) {
  visit_fields(static_cast<const device::HealthAccount&>(v), field);
  field("valid_at_s", v.valid_at_s);
  field("received_at_s", v.received_at_s);
  field("device_time_s", v.device_time_s);
  field("latency_s", v.latency_s);
  field("can_state", v.can_state);
  field("bits_per_second", v.bits_per_second);
  field("bus_load", v.bus_load);
  field("finding", v.finding);
  field("told", v.told);
  field("values", v.values);
  field("problems", problems_of(v));
}

namespace {

constexpr std::size_t values_width = 100;  // columns of the rows of values

std::string milliseconds(std::optional<double> s) {
  return s ? fmt::format("{:.1f} ms", *s * 1e3) : std::string("-");
}

std::string times(const DeviceView& v) {
  if (!v.received_at_s) return {};
  std::string text =
      fmt::format("  arrived {}  valid at {}  latency {}", clock_text(*v.received_at_s),
                  clock_text(*v.valid_at_s), milliseconds(v.latency_s));
  if (v.device_time_s) text += "  device time " + device_clock_text(*v.device_time_s);
  return text;
}

std::string bus_text(const DeviceView& v) {
  if (!v.bits_per_second && v.error_frames == 0 && v.can_dropped == 0 && v.can_state.empty())
    return {};
  std::string text = "  bus";
  if (v.bits_per_second) text += fmt::format(" {:.1f} kbit/s", *v.bits_per_second / 1e3);
  if (v.bus_load) text += fmt::format(" = load {:.1f} %", 100 * *v.bus_load);
  if (!v.can_state.empty()) text += "  controller " + v.can_state;
  return text + fmt::format("  {} error frames  {} lost", v.error_frames, v.can_dropped);
}

void add_rows_of_values(const DeviceView& v, std::vector<std::string>& lines) {
  std::string row;
  for (const auto& value : v.values) {
    const std::string text = "  " + value.name + ' ' + value.full();
    if (!row.empty() && row.size() + text.size() > values_width)
      lines.push_back(std::exchange(row, {}));
    row += text;
  }
  if (!row.empty()) lines.push_back(std::move(row));
}

/// The finding with its age: "dvl: silent for 12.3 s: ...".
std::string finding_line(const diagnosis::FindingAccount& finding) {
  const double now_s = measurement::seconds(link::now().time_since_epoch());
  return diagnosis::line_of(finding, fmt::format("for {:.1f} s", now_s - finding.since_s));
}

}  // namespace

DeviceView view_of(const device::Device& device, const device::Health& health) {
  DeviceView view;
  static_cast<device::HealthAccount&>(view) =
      device::account_of(device, health, host::provenance_of(device.options().link));
  view.streaming = health.state == device::State::streaming;
  return view;
}

void show_values(const LastValues& last, std::uint16_t device, const DisplayUnits& units,
                 DeviceView& view) {
  view.values = last.values(device, units);
  const auto newest = last.newest(device);
  if (!newest) return;
  view.valid_at_s = measurement::seconds(newest->valid_at.time_since_epoch());
  view.received_at_s = measurement::seconds(newest->received_at.time_since_epoch());
  view.latency_s = measurement::seconds(newest->received_at - newest->valid_at);
  view.device_time_s.reset();
  if (newest->device_time) view.device_time_s = measurement::seconds(*newest->device_time);
}

Palette::Palette(bool terminal) {
  const char* no_colour = std::getenv("NO_COLOR");
  colour_ = terminal && (no_colour == nullptr || *no_colour == '\0');
}

std::string Palette::state(std::string_view state, std::string_view text) const {
  if (!colour_) return std::string(text);
  const char* colour = state == "streaming"     ? "\033[32m"
                       : state == "stale"       ? "\033[33m"
                       : state == "backing off" ? "\033[31m"
                                                : "\033[36m";
  return fmt::format("{}{}\033[0m", colour, text);
}

std::string headline(const DeviceView& v, const Palette& palette) {
  return fmt::format(
      "{:<10} {} {:>8.2f} Hz of {:>6.1f}  jitter {:>8}  {:>9} messages  {:>8} B skipped  {:>5} bad"
      "  age {:>6}",
      v.name, palette.state(v.state, fmt::format("{:<11}", v.state)), v.rate_hz, v.nominal_rate_hz,
      milliseconds(v.jitter_s), v.messages, v.bytes_skipped, v.bad_checksums,
      v.age_s ? fmt::format("{:.3f} s", *v.age_s) : std::string("-"));
}

std::vector<std::string> table_lines(const std::vector<DeviceView>& views) {
  const Palette plain(false);
  std::vector<std::string> all;
  for (const DeviceView& v : views) {
    all.push_back(headline(v, plain));
    all.push_back(fmt::format("  {} {} on {}: {} good frames, {} bad, {} B; longest gap {}", v.kind,
                              v.protocol, v.link, v.frames, v.bad_checksums, v.bytes_in,
                              milliseconds(v.longest_interval_s)));
    if (v.finding) all.push_back("  found " + finding_line(*v.finding));
    if (auto line = bus_text(v); !line.empty()) all.push_back(std::move(line));
    if (v.refused > 0) all.push_back(fmt::format("  {} values refused", v.refused));
    if (!v.link_note.empty()) all.push_back("  link: " + v.link_note);
    if (!v.told.empty()) all.push_back("  was told: " + v.told);
    if (auto line = times(v); !line.empty()) all.push_back(std::move(line));
    add_rows_of_values(v, all);
    if (!v.hint.empty()) all.push_back("  " + v.hint);
    if (!v.shared_with.empty())
      all.push_back("  each reads a part of the bytes: also open in " + v.shared_with);
    const bool with_status = !v.streaming && !v.status.empty();
    if (with_status) all.push_back("  " + v.status);
    if (!v.last_error.empty() && !(with_status && v.last_error == v.status))
      all.push_back("  last error: " + v.last_error);
  }
  return all;
}

void Overdrawn::draw(std::vector<std::string> lines) {
  const auto [columns, rows] = terminal::screen_size(::fileno(out_));
  if (lines.size() >= rows) lines.resize(rows - 1);  // the cursor cannot go up to what scrolled off
  std::string out = "\033[?7l";  // a line that is too long after all wraps no row
  if (drawn_ > 0) out += fmt::format("\033[{}A", drawn_);
  for (const auto& line : lines) out += "\r\033[2K" + cut_row(line, columns) + "\n";
  for (std::size_t i = lines.size(); i < drawn_; ++i) out += "\r\033[2K\n";
  drawn_ = std::max(drawn_, lines.size());
  out += "\033[?7h";
  std::fwrite(out.data(), 1, out.size(), out_);
  std::fflush(out_);
}

void print_json(const std::vector<DeviceView>& views, std::FILE* out) {
  text::JsonLines lines(out);
  for (const auto& view : views) lines.line([&](text::JsonWriter& json) { json.fields(view); });
  lines.flush();
  std::fflush(out);
}

}  // namespace drydock::monitor
