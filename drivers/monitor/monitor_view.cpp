#include "drivers/monitor/monitor_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "drivers/diagnosis/finding_words.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/link/link.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/text/measurement_fields.hpp"

namespace drydock::monitor {

template <class F>
void visit_fields(const ShownValue& v, F&& field) {
  field("name", v.name);
  field("text", v.text);
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
  field("values", v.values);
}

namespace {

/// "velocity_mps" is a velocity in m/s: gives the name and its unit. Longer endings come first.
std::pair<std::string_view, std::string_view> split_unit(std::string_view field) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> units{{
      {"_mps2", "m/s2"},
      {"_degps", "deg/s"},
      {"_radps", "rad/s"},
      {"_dbhz", "dBHz"},
      {"_mps", "m/s"},
      {"_deg", "deg"},
      {"_pa", "Pa"},
      {"_m", "m"},
      {"_k", "K"},
      {"_s", "s"},
  }};
  for (const auto& [ending, unit] : units)
    if (field.ends_with(ending)) return {field.substr(0, field.size() - ending.size()), unit};
  return {field, ""};
}

/// Lists the values of a measurement's fields as text. It omits values that are not available.
class Lister {
 public:
  explicit Lister(std::vector<ShownValue>& values) : values_(values) {}

  template <class T>
  void operator()(std::string_view field, const T& content) {
    const std::string text = in_text(content);
    if (text.empty()) return;
    const auto [name, unit] = split_unit(field);
    values_.push_back({std::string(name), unit.empty() ? text : fmt::format("{} {}", text, unit)});
  }

 private:
  static std::string in_text(double number) { return fmt::format("{:.5g}", number); }
  template <std::integral T>
  static std::string in_text(T number) {
    return fmt::format("{}", number);
  }
  template <class T>
  static std::string in_text(const std::optional<T>& maybe) {
    return maybe ? in_text(*maybe) : std::string();
  }
  template <class Range>
  requires requires(const Range& range) { range.begin(), range.end(); }
  static std::string in_text(const Range& range) {
    using Item = std::decay_t<decltype(*range.begin())>;
    if constexpr (std::is_class_v<Item> && !std::is_same_v<Item, std::optional<double>>) {
      return fmt::format("{}", range.size());  // for satellites: their number
    } else {
      std::string text;
      for (const auto& item : range) {
        std::string part = in_text(item);
        text += (text.empty() ? "" : " ") + (part.empty() ? std::string("-") : part);
      }
      return text;
    }
  }

  std::vector<ShownValue>& values_;
};

std::string milliseconds(std::optional<double> s) {
  return s ? fmt::format("{:.1f} ms", *s * 1e3) : std::string("-");
}

std::string times(const DeviceView& v) {
  if (!v.received_at_s) return {};
  std::string text = fmt::format("  arrived {:.3f}  valid at {:.3f}  latency {}", *v.received_at_s,
                                 *v.valid_at_s, milliseconds(v.latency_s));
  if (v.device_time_s) text += fmt::format("  device time {:.3f} s", *v.device_time_s);
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

void Latest::on_measurement(const measurement::Measurement& measurement) {
  const auto device = std::visit([](const auto& m) { return m.origin.device; }, measurement);
  measurements_.insert_or_assign({device, measurement.index()}, measurement);
}

void Latest::show(std::uint16_t device, DeviceView& view) const {
  view.values.clear();
  std::optional<measurement::Origin> newest;
  const auto first = measurements_.lower_bound({device, 0});
  for (auto entry = first; entry != measurements_.end() && entry->first.first == device; ++entry) {
    std::visit(
        [&](const auto& m) {
          if (!newest || m.origin.received_at > newest->received_at) newest = m.origin;
          visit_fields(m, Lister(view.values));
        },
        entry->second);
  }
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

std::string Palette::changed(std::string_view text) const {
  return colour_ ? fmt::format("\033[7m{}\033[0m", text) : std::string(text);
}

std::string headline(const DeviceView& v, const Palette& palette) {
  return fmt::format(
      "{:<10} {} {:>8.2f} Hz of {:>6.1f}  jitter {:>8}  {:>9} messages  {:>8} B skipped  {:>5} bad"
      "  age {:>6}",
      v.name, palette.state(v.state, fmt::format("{:<11}", v.state)), v.rate_hz, v.nominal_rate_hz,
      milliseconds(v.jitter_s), v.messages, v.bytes_skipped, v.bad_checksums,
      v.age_s ? fmt::format("{:.3f} s", *v.age_s) : std::string("-"));
}

std::string DeviceTable::value_text(const DeviceView& view, const ShownValue& value) {
  std::string& before = before_[view.name + '/' + value.name];
  const bool is_new = before != value.text;
  before = value.text;
  return value.name + " " + (is_new ? palette_.changed(value.text) : value.text);
}

std::vector<std::string> DeviceTable::lines(const std::vector<DeviceView>& views) {
  std::vector<std::string> all;
  for (const DeviceView& v : views) {
    all.push_back(headline(v, palette_));
    all.push_back(fmt::format("  {} {} on {}: {} good frames, {} bad, {} B; longest gap {}", v.kind,
                              v.protocol, v.link, v.frames, v.bad_checksums, v.bytes_in,
                              milliseconds(v.longest_interval_s)));
    if (v.finding) all.push_back("  found " + finding_line(*v.finding));
    if (auto line = bus_text(v); !line.empty()) all.push_back(std::move(line));
    if (v.refused > 0) all.push_back(fmt::format("  {} values refused", v.refused));
    if (!v.link_note.empty()) all.push_back("  link: " + v.link_note);
    if (auto line = times(v); !line.empty()) all.push_back(std::move(line));
    std::string values;
    for (const auto& value : v.values) values += "  " + value_text(v, value);
    if (!values.empty()) all.push_back(std::move(values));
    const bool with_status = !v.streaming && !v.status.empty();
    if (with_status) all.push_back("  " + v.status);
    if (!v.last_error.empty() && !(with_status && v.last_error == v.status))
      all.push_back("  last error: " + v.last_error);
  }
  return all;
}

void Overdrawn::draw(const std::vector<std::string>& lines) {
  std::string out = "\033[?7l";  // cuts a long line, does not wrap it: each line is one row
  if (drawn_ > 0) out += fmt::format("\033[{}A", drawn_);
  for (const auto& line : lines) out += "\r\033[2K" + line + "\n";
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
