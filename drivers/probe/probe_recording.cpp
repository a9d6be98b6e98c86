#include "drivers/probe/probe_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "drivers/capture/arrival_times.hpp"
#include "drivers/capture/foreign_content.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/link/can/frame_file.hpp"
#include "drivers/probe/probe_bus.hpp"
#include "drivers/probe/probe_line.hpp"
#include "drivers/probe/unknown_file.hpp"
#include "drivers/shell/recording_clock.hpp"
#include "rig_config/device_description/load_description.hpp"

namespace drydock::probe {
namespace {

using link::Stamp;

/// True if the capture keeps when its frames arrived.
bool tells_arrival(const link::Uri& uri) {
  auto file = link::capture_of(uri);
  return capture::arrival_times_of(file).are_told();
}

/// The buses of a capture by their names: each has its own nodes.
struct Buses {
  std::map<std::string, survey::BusSurvey, std::less<>> surveys;
  std::optional<Stamp> first, last;

  void take(const capture::Record& record, bool timed,
            const survey::BusSurvey::Descriptions& descriptions) {
    if (timed) last = std::max(last.value_or(Stamp{*record.time}), Stamp{*record.time});
    if (!first) first = last;
    auto bus = surveys.find(record.interface);
    if (bus == surveys.end())
      bus = surveys.try_emplace(std::string(record.interface), descriptions).first;
    bus->second.receive(record.frame, timed ? Stamp{*record.time} : Stamp{});
  }
};

/// The link of one line or bus of the file; empty: the name cannot stand in a link.
std::string link_to(const link::Uri& uri, const std::string& name, ProbeReport& report) {
  auto text = with_key(uri.text, "interface", name);
  if (!name.empty() && link::parse_uri(text)) return text;
  report.notes.push_back("the name \"" + name +
                         "\" cannot stand in a link: drydock decode "
                         "--interface takes it");
  return {};
}

/// Surveys a CAN capture, in its own time. False if the content is no CAN capture.
bool read_frames(const link::Uri& uri, const survey::BusSurvey::Descriptions& descriptions,
                 ProbeReport& report) {
  auto file = link::capture_of(uri);
  Buses buses;
  const bool timed = tells_arrival(uri);
  while (const auto record = file.next()) buses.take(*record, timed, descriptions);
  if (!file.trouble().empty() || buses.surveys.empty()) return false;
  if (buses.first) report.listened_s = measurement::seconds(*buses.last - *buses.first);
  for (auto note : {std::string(file.frames().note()), file.times().in_words(),
                    capture::left_out_text(file.frames().tally())})
    if (!note.empty()) report.recording.push_back(std::move(note));
  if (buses.surveys.size() == 1)
    note_bus(buses.surveys.begin()->second, uri.text, report);
  else
    for (const auto& [name, survey] : buses.surveys)
      note_one_bus(survey, name, link_to(uri, name, report), report);
  if (!timed) report.notes.emplace_back("the capture keeps no times of arrival: no rates");
  return true;
}

constexpr double shortest_s = 0.5;  // what came at once tells no rate

/// The rates of a line's sensors: by the times of arrival that the capture keeps, else by the
/// device's own clock, else none.
void note_times(const link::Uri& uri, ProbeReport& report) {
  for (auto& found : report.devices) {
    if (found.link != uri.text) continue;
    device::DriverOptions driver;
    driver.kind = found.kind;
    driver.protocol = found.protocol;
    driver.description = found.description;
    const auto clock = shell::clock_of(uri, driver, device::Travels::as_bytes);
    if (clock.pace != shell::Pace::arrival || report.listened_s < shortest_s)
      found.rate_hz = clock.usual_rate_hz();
    if (clock.pace == shell::Pace::device)
      report.listened_s = std::max(report.listened_s, clock.seconds());
    report.notes.push_back(found.name + ": " + clock.in_words());
  }
}

/// Surveys a line of bytes in a capture.
bool read_line(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  capture::LineFile line(uri.target, uri.text_of("format") == "raw",
                         std::string(uri.text_of("interface")));
  survey::ByteSurvey survey(options.descriptions, rig_config::shipped_descriptions());
  std::optional<std::chrono::nanoseconds> first, last;
  while (const auto read = line.next()) {
    if (!first) first = read->time;
    last = read->time;
    survey.feed(read->bytes, Stamp{last.value_or(std::chrono::nanoseconds{})});
  }
  if (auto trouble = line.trouble(); !trouble.empty()) {
    report.notes.push_back(std::move(trouble));
    return false;
  }
  survey.finish();
  if (first && last)
    report.listened_s = std::max(report.listened_s, measurement::seconds(*last - *first));
  for (auto note : {line.damage(), line.cut_note(), line.clock_note(), line.note()})
    if (!note.empty() && std::ranges::find(report.recording, note) == report.recording.end())
      report.recording.push_back(std::move(note));
  note_line(survey, std::string(uri.text_of("interface")), uri.text, report);
  note_times(uri, report);
  return true;
}

/// A capture of a whole network has hundreds of lines, of which few are of sensors.
constexpr std::size_t most_lines = 16;

/// The lines of a file of packets that said most, each as if it were the file's only one.
bool read_lines(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  capture::LineFile all(uri.target, false, "*");
  while (all.next()) continue;
  auto lines = all.lines();
  std::erase_if(lines, [](const auto& line) { return line.bytes == 0; });
  if (lines.size() > most_lines) {
    report.notes.push_back(
        fmt::format("{} lines with fewer bytes were not looked at: interface= "
                    "names one, drydock info lists all",
                    lines.size() - most_lines));
    std::ranges::stable_sort(lines, std::greater{}, [](const auto& line) { return line.bytes; });
    lines.resize(most_lines);
  }
  report.has_lines = true;
  bool any = false;
  for (const auto& line : lines) {
    const auto one = link_to(uri, line.name, report);
    any = (!one.empty() && read_line(link::parse_uri(one).value(), options, report)) || any;
  }
  return any;
}

/// Surveys a capture of bytes.
bool read_bytes(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  const bool raw = uri.text_of("format") == "raw";
  const bool several = !raw && uri.text_of("interface").empty() && capture::has_packets(uri.target);
  if (several && read_lines(uri, options, report)) return true;
  if (several) {
    capture::LineFile line(uri.target, false);
    line.next();
    const auto trouble = line.trouble();
    report.notes.push_back(trouble.empty() ? "none of its lines can be read" : trouble);
    return false;
  }
  const auto advice = capture::foreign_content(capture::FileBlocks(uri.target).read());
  if (!read_line(uri, options, report)) return false;
  if (!advice.empty()) report.notes.emplace_back(advice);
  if (advice.empty() && report.attempts.back().findings.empty())
    report.notes.push_back(what_it_may_be(uri.target, raw));
  return true;
}

}  // namespace

std::string with_key(const std::string& uri, std::string_view key, std::string_view value) {
  return fmt::format("{}{}{}={}", uri, uri.find('?') == std::string::npos ? '?' : '&', key, value);
}

bool read_recording(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  if (!read_frames(uri, options.descriptions, report)) return read_bytes(uri, options, report);
  if (uri.text_of("interface").empty() && uri.text_of("format").empty() &&
      capture::has_packets(uri.target))
    read_lines(uri, options, report);
  return true;
}

}  // namespace drydock::probe
