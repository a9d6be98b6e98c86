#include "drivers/probe/probe_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "drivers/capture/frame_capture.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/probe/setting_search.hpp"
#include "drivers/survey/position_talkers.hpp"
#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"
#include "rig_config/device_description/load_description.hpp"

namespace drydock::probe {
namespace {

using link::Stamp;
using survey::ByteSurvey;
using std::chrono_literals::operator""ms;

/// Questions that change nothing: UBX-MON-VER, and Water Linked's version. docs/pier/probe.md
std::vector<std::uint8_t> questions() {
  std::array<std::uint8_t, wire::ubx::overhead> poll;
  constexpr std::uint16_t mon_ver = 0x0A04;
  wire::ubx::wrap(poll, mon_ver, 0);
  std::vector<std::uint8_t> all(poll.begin(), poll.end());
  for (const char c : std::string_view("\r\nwcv\r\n")) all.push_back(static_cast<std::uint8_t>(c));
  return all;
}

/// The link of the bus behind a line. Precondition: `line` is a link for bytes.
std::string bus_behind(const link::Uri& line, std::string_view format) {
  const bool is_port = line.scheme == link::Scheme::serial;
  const std::string way = is_port ? line.target : line.text.substr(0, line.text.find('?'));
  const auto rate = is_port ? line.baud() : std::nullopt;
  return fmt::format("gateway:{}?format={}{}", way, format,
                     rate ? fmt::format("&baud={}", *rate) : "");
}

/// A gateway of NMEA 2000 sends its frames as lines of text.
std::string gateway_note(wire::Bytes head, const std::string& text) {
  capture::FrameCapture frames;
  frames.feed(head);
  frames.finish();
  if (!frames.next() || frames.format() == nullptr) return {};
  const std::string_view format = frames.format()->name;
  const auto line = link::parse_uri(text).value();
  if (const auto bus = link::parse_uri(bus_behind(line, format)))
    return fmt::format("a gateway that sends CAN frames as text ({}): probe '{}'", format,
                       bus->text);
  return fmt::format(
      "{} sends CAN frames as text ({}), which no link reads live: write what it sends into a "
      "file, with nc or socat, and probe or replay that",
      text, format);
}

std::string found_so_far(const Hearing& hearing) {
  const auto best = hearing.eight.best();
  if (best.confidence == survey::Confidence::nothing)
    return fmt::format("{} bytes", hearing.eight.bytes());
  return fmt::format("{} ({}), {}", best.protocol, to_string(best.confidence),
                     survey::reasons(best));
}

std::string progress_text(const LineSearch& search, const Attempt& attempt, Stamp now) {
  const double left = std::max(0.0, measurement::seconds(search.until - now));
  return fmt::format("{}: {}; {:.0f} s left, Ctrl-C ends with what was found",
                     attempt.setting.baud > 0 ? in_words(attempt.setting) : search.link,
                     found_so_far(attempt.hearing), left);
}

/// Opens the link with the attempt's setting and listens. The error is that of the open.
std::optional<link::OpenError> listen(const LineSearch& search, Attempt& attempt, Ear& ear,
                                      Progress& progress) {
  const bool serial = attempt.setting.baud > 0;
  const auto text = serial ? with_keys(search.link, attempt.setting) : search.link;
  auto opened = link::open_bytes(ear.executor(), link::parse_uri(text).value(), link::Side::driver);
  if (!opened) return opened.error();
  attempt.since = link::steady_now();
  bool asked = !search.ask;
  ear.listen(**opened, search.until, [&](wire::Bytes bytes, Stamp at) {
    const bool enough = attempt.hear(bytes, at, serial);
    if (!asked && at - attempt.since > 500ms &&
        attempt.hearing.confidence() == survey::Confidence::nothing) {
      asked = true;
      ear.say(**opened, questions());
    }
    if (bytes.empty()) progress.show(progress_text(search, attempt, at));
    return enough;
  });
  attempt.note = (*opened)->note();
  return {};
}

void report_into(ProbeReport& report, const Attempt& attempt, const std::string& link) {
  const bool serial = attempt.setting.baud > 0;
  const auto heard = attempt.heard_as();
  if (!attempt.note.empty()) report.notes.push_back(attempt.note);
  const std::string line = serial ? with_keys(link, heard) : link;
  if (auto gateway = gateway_note(attempt.hearing.head, line); !gateway.empty())
    report.notes.push_back(std::move(gateway));
  note_line(attempt.survey(), serial ? in_words(heard) : "", line, report);
}

}  // namespace

Progress::Progress(std::FILE* err) : err_(err), terminal_(terminal::erases_lines(::fileno(err))) {}

Progress::~Progress() {
  if (shown_ > 0) fmt::print(err_, "{}", terminal::wipe_line);
  std::fflush(err_);
}

void Progress::show(const std::string& text) {
  if (!terminal_) return;
  fmt::print(err_, "{}{}", terminal::wipe_line, text);
  std::fflush(err_);
  ++shown_;
}

void note_line(const survey::ByteSurvey& survey, const std::string& setting,
               const std::string& link, ProbeReport& report) {
  LineAttempt attempt{setting, link, survey.bytes(), survey.findings()};
  for (const auto& sensor : survey::sensors_of(attempt.findings))
    report.devices.push_back({"", sensor.kind, std::string(sensor.protocol), link, sensor.rate_hz,
                              0, sensor.description});
  if (!attempt.findings.empty() && attempt.findings.front().protocol == "slcan")
    report.notes.push_back("a serial CAN adapter that is open: probe slcan:" + link);
  if (!attempt.findings.empty())
    if (auto note = survey::note_of_receivers(attempt.findings.front()); !note.empty())
      report.notes.push_back(std::move(note));
  survey::name_devices(report.devices);
  report.attempts.push_back(std::move(attempt));
}

bool search_line(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report) {
  const bool serial = search.link.starts_with("serial:");
  const bool fixed_parity = search.link.find("parity=") != std::string::npos;
  const auto& shipped = rig_config::shipped_descriptions();
  SettingSearch settings;
  settings.plain = serial ? settings_of(search.link, "N") : std::vector<LineSetting>{{}};
  if (serial && !fixed_parity) settings.with_parity = settings_of(search.link, "EO");
  const bool may_leave = serial && (settings.plain.size() > 1 || !fixed_parity);
  settings.make = [&](const LineSetting& setting) {
    return std::unique_ptr<Attempt>(
        new Attempt{setting, Hearing(search.descriptions, shipped), may_leave});
  };
  std::string first_failure;
  settings.listen = [&](Attempt& attempt) {
    if (const auto failure = listen(search, attempt, ear, progress)) {
      if (first_failure.empty()) first_failure = failure->message;
      return Listened::refused;
    }
    const bool last = ear.interrupted() || link::steady_now() >= search.until;
    return last ? Listened::last : Listened::heard;
  };
  const auto attempts = search_settings(settings);
  if (attempts.empty()) {
    report.notes.push_back(first_failure);
    return false;
  }
  // Only the devices of the best attempt are real: the same sensor at another rate is noise.
  for (const auto& attempt : attempts) {
    report.devices.clear();
    report_into(report, *attempt, search.link);
  }
  return true;
}

}  // namespace drydock::probe
