#include "drivers/probe/probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/error.hpp>
#include <functional>

#include "drivers/capture/arrival_times.hpp"
#include "drivers/capture/foreign_content.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/doctor/holders.hpp"
#include "drivers/link/can/frame_file.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/probe/probe_bus.hpp"
#include "drivers/probe/typed_link.hpp"
#include "drivers/shell/recording_clock.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::probe {
namespace {

using link::Carries;
using link::Stamp;

std::string with_key(const std::string& uri, std::string_view key, std::string_view value) {
  return fmt::format("{}{}{}={}", uri, uri.find('?') == std::string::npos ? '?' : '&', key, value);
}

/// Parses the URI. If the rate is missing it puts one in: the probe searches for the rate.
boost::system::result<link::Uri, link::UriError> parse_without_baud(const std::string& text) {
  const bool missing = text.starts_with("serial:") && text.find("baud=") == std::string::npos;
  if (!missing) return link::parse_uri(text);
  return link::parse_uri(with_key(text, "baud", "9600"));
}

/// True if the capture keeps when its frames arrived.
bool tells_arrival(const link::Uri& uri) {
  auto file = link::capture_of(uri);
  capture::ArrivalTimes arrivals;
  while (!arrivals.enough()) {
    const auto record = file.next();
    if (!record) break;
    arrivals.add(*record);
  }
  return arrivals.are_told();
}

/// Surveys a CAN capture, in its own time. False if the content is no CAN capture.
bool read_frames(const link::Uri& uri, const survey::BusSurvey::Descriptions& descriptions,
                 ProbeReport& report) {
  auto file = link::capture_of(uri);
  survey::BusSurvey survey(descriptions);
  Stamp first{}, last{};
  const bool timed = tells_arrival(uri);
  bool any = false;
  while (const auto record = file.next()) {
    any = true;
    if (timed) last = Stamp{*record->time};
    if (survey.frames() == 0) first = last;
    survey.receive(record->frame, last);
  }
  if (!file.trouble().empty() || !any) return false;
  report.listened_s = measurement::seconds(last - first);
  note_bus(survey, uri.text, report);
  if (!timed) report.notes.emplace_back("the capture keeps no times of arrival: no rates");
  return true;
}

constexpr double shortest_s = 0.5;  // what came at once tells no rate

/// The rates of a line's sensors: by the times of arrival that the capture keeps, else by the
/// device's own clock, else none.
void note_times(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  for (auto& found : report.devices) {
    if (found.link != uri.text) continue;
    device::DriverOptions driver;
    driver.kind = found.kind;
    driver.protocol = found.protocol;
    for (const auto* list : {&options.shipped, &options.descriptions})
      for (const auto& description : *list)
        if (description->name == found.protocol) driver.description = description;
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
  survey::ByteSurvey survey(options.descriptions, options.shipped);
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
  if (const auto damage = line.damage(); !damage.empty()) report.notes.push_back(damage);
  if (line.is_hex()) report.notes.emplace_back("hexadecimal text, read as the bytes that it means");
  note_line(survey, std::string(uri.text_of("interface")), uri.text, report);
  note_times(uri, options, report);
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
    const auto one = link::parse_uri(with_key(uri.text, "interface", line.name));
    any = (one && read_line(*one, options, report)) || any;
  }
  return any;
}

/// Surveys a capture of bytes.
bool read_bytes(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  const bool raw = uri.text_of("format") == "raw";
  const bool several = !raw && uri.text_of("interface").empty() && capture::has_packets(uri.target);
  if (several && read_lines(uri, options, report)) return true;
  if (const auto advice = capture::foreign_content(capture::FileBlocks(uri.target).read());
      !advice.empty())
    report.notes.emplace_back(advice);
  return !several && read_line(uri, options, report);
}

/// A file of packets may hold buses and lines.
bool read_recording(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report) {
  if (!read_frames(uri, options.descriptions, report)) return read_bytes(uri, options, report);
  if (uri.text_of("interface").empty() && uri.text_of("format").empty() &&
      capture::has_packets(uri.target))
    read_lines(uri, options, report);
  return true;
}

/// Other programs that have the port open, in words: each byte goes to only one of them.
std::string others_at(const link::Uri& uri) {
  const bool pty = uri.scheme == link::Scheme::pty || uri.scheme == link::Scheme::can_auto;
  if (!pty && uri.scheme != link::Scheme::serial) return {};
  return doctor::in_words(doctor::holders_of("/", pty ? link::pty_path(uri.target) : uri.target));
}

bool search(const ProbeOptions& options, const link::Uri& uri, std::FILE* err,
            ProbeReport& report) {
  if (uri.recorded()) return read_recording(uri, options, report);
  Ear ear;
  Progress progress(err);
  const Stamp start = link::steady_now();
  const LineSearch wanted{report.link, start + measurement::from_seconds(options.duration_s),
                          options.ask, options.descriptions, options.shipped};
  const bool opened = uri.carries() == Carries::bytes ? search_line(wanted, ear, progress, report)
                                                      : search_bus(wanted, ear, progress, report);
  report.listened_s = measurement::seconds(link::steady_now() - start);
  report.interrupted = ear.interrupted();
  if (opened) report.shared_with = others_at(uri);
  if (uri.scheme == link::Scheme::pty && opened)
    report.notes.push_back("a pty has no baud rate: any will do");
  return opened;
}

/// Adds the most frequent cause of silence or noise.
void note_nothing(const link::Uri& uri, ProbeReport& report) {
  if (uri.carries() != Carries::bytes || report.confidence() != survey::Confidence::nothing) return;
  std::uint64_t bytes = 0;
  for (const auto& attempt : report.attempts) bytes += attempt.bytes;
  if (report.attempts.empty()) return;
  if (uri.recorded() && bytes == 0) {
    report.notes.push_back("the file holds no bytes but comments (format=raw keeps them)");
    return;
  }
  report.notes.push_back(
      bytes == 0
          ? "silence: no power, receive and transmit exchanged, or a sensor that waits to be "
            "asked (--ask)"
          : "bytes, but no protocol that we know: a rate not tried, RS-422 with A and B "
            "exchanged, or another protocol");
}

}  // namespace

ProbeReport find_sensors(const std::string& link, double duration_s) {
  ProbeReport report;
  report.link = typed_link(link);
  ProbeOptions options;
  options.link = link;
  options.duration_s = duration_s;
  const auto uri = parse_without_baud(report.link);
  if (!uri) {
    report.notes.push_back(uri.error().message);
  } else if (search(options, *uri, stderr, report)) {
    note_nothing(*uri, report);
  }
  return report;
}

int probe(const ProbeOptions& options, std::FILE* out, std::FILE* err) {
  ProbeReport report;
  report.link = typed_link(options.link);
  const auto uri = parse_without_baud(report.link);
  if (!uri) {
    fmt::print(err, "probe: {}\n", uri.error().message);
    return terminal::exit_usage;
  }
  if (!search(options, *uri, err, report)) {
    report.opened = false;
    fmt::print(err, "probe: {}\n", problems_of(report).front());
    if (options.json) print_json(report, out);
    return terminal::exit_failed;
  }
  note_nothing(*uri, report);
  if (options.json) {
    print_json(report, out);
  } else {
    print_text(report, out);
  }
  return terminal::exit_of(problems_of(report).empty());
}

}  // namespace drydock::probe
