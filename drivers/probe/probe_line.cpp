#include "drivers/probe/probe_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "drivers/capture/frame_capture.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/probe/hearing.hpp"
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

/// The most likely rates first: the factory settings of DVLs, EM logs and receivers.
constexpr std::array bauds{115200, 9600, 4800, 38400, 57600, 19200, 230400, 460800, 921600};

/// A possible setting of a line. The bytes of 8N1 show 7 data bits too: no port needs that setting.
struct Setting {
  int baud;
  char parity;  ///< N, E, O
};

std::string in_words(const Setting& s, int bits) {
  return fmt::format("{} {}{}1", s.baud, bits, s.parity);
}

std::string with_keys(std::string uri, const Setting& s, int bits) {
  const auto add = [&](const std::string& key) {
    uri += (uri.find('?') == std::string::npos ? '?' : '&') + key;
  };
  if (uri.find("baud=") == std::string::npos) add(fmt::format("baud={}", s.baud));
  if (s.parity != 'N') add(s.parity == 'E' ? "parity=even" : "parity=odd");
  if (bits == 7) add("bits=7");
  return uri;
}

/// In this time a stream without pauses brings a whole message, of up to 2048 bytes. All rates with
/// 8N1 and with even parity then fit into half a minute.
std::chrono::milliseconds patience(int baud) {
  constexpr std::int64_t bits_ms = 2048 * 10 * 1000;
  return std::clamp(std::chrono::milliseconds(bits_ms / std::max(baud, 1)), 1000ms, 3000ms);
}

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

/// Listens with one setting. The best of its three decodings goes into the report.
class Attempt {
 public:
  Attempt(const LineSearch& search, Setting setting, bool serial)
      : search_(search),
        setting_(setting),
        serial_(serial),
        hearing_(search.descriptions, rig_config::shipped_descriptions()) {}

  std::optional<link::OpenError> run(Ear& ear, Progress& progress, bool may_leave) {
    const auto uri = link::parse_uri(uri_with(8)).value();
    auto opened = link::open_bytes(ear.executor(), uri, link::Side::driver);
    if (!opened) return opened.error();
    const Stamp since = link::steady_now();
    bool asked = !search_.ask;
    ear.listen(**opened, search_.until, [&](wire::Bytes bytes, Stamp at) {
      if (!bytes.empty()) hearing_.feed(bytes, at, serial_ && setting_.parity == 'N');
      hearing_.pause(at);
      if (!asked && at - since > 500ms && hearing_.confidence() == survey::Confidence::nothing) {
        asked = true;
        ear.say(**opened, questions());
      }
      if (bytes.empty()) progress.show(progress_text(at));
      return hearing_.settled() ||
             (may_leave && hearing_.hopeless(at, since, patience(setting_.baud)));
    });
    note_ = (*opened)->note();
    return {};
  }

  const Hearing& hearing() const { return hearing_; }
  Setting setting() const { return setting_; }

  void report_into(ProbeReport& report) const {
    const auto strength = [](const survey::ByteSurvey& s) { return s.best().confidence; };
    const bool is_even = strength(hearing_.even) > strength(hearing_.eight);
    const bool is_odd =
        strength(hearing_.odd) > std::max(strength(hearing_.eight), strength(hearing_.even));
    const int bits = is_even || is_odd ? 7 : 8;
    Setting heard = setting_;
    if (bits == 7) heard.parity = is_odd ? 'O' : 'E';
    const auto& survey = is_odd ? hearing_.odd : is_even ? hearing_.even : hearing_.eight;
    if (!note_.empty()) report.notes.push_back(note_);
    const std::string line = serial_ ? with_keys(search_.link, heard, bits) : search_.link;
    if (auto gateway = gateway_note(hearing_.head, line); !gateway.empty())
      report.notes.push_back(std::move(gateway));
    note_line(survey, serial_ ? in_words(heard, bits) : "", line, report);
  }

 private:
  std::string uri_with(int bits) const {
    return serial_ ? with_keys(search_.link, setting_, bits) : search_.link;
  }
  std::string progress_text(Stamp now) const {
    const double left = std::max(0.0, measurement::seconds(search_.until - now));
    return fmt::format("{}: {}; {:.0f} s left, Ctrl-C ends with what was found",
                       serial_ ? in_words(setting_, 8) : search_.link, found_so_far(hearing_),
                       left);
  }

  LineSearch search_;
  Setting setting_;
  bool serial_;
  Hearing hearing_;
  std::string note_;  ///< of the link
};

/// The settings with one of these parities: every rate, or that of the URI.
std::vector<Setting> settings_of(const std::string& uri, std::string_view parities) {
  const auto parsed = link::parse_uri(uri);
  const bool fixed_baud = uri.find("baud=") != std::string::npos;
  std::vector<Setting> settings;
  for (const char parity : parities) {
    if (fixed_baud && parsed) {
      settings.push_back({static_cast<int>(parsed->baud().value_or(0)), parity});
    } else {
      for (const int baud : bauds) settings.push_back({baud, parity});
    }
  }
  return settings;
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
  const auto plain = serial ? settings_of(search.link, "N") : std::vector<Setting>{{0, 'N'}};
  const bool may_leave = serial && (plain.size() > 1 || !fixed_parity);
  std::vector<std::unique_ptr<Attempt>> attempts;
  bool over = false;
  // Nothing if the port does not support the setting.
  const auto listen = [&](Setting setting) -> std::unique_ptr<Attempt> {
    auto attempt = std::make_unique<Attempt>(search, setting, serial);
    const auto failure = attempt->run(ear, progress, may_leave);
    if (failure && attempts.empty()) report.notes.push_back(failure->message);
    over = (failure && attempts.empty()) || attempt->hearing().settled() || ear.interrupted() ||
           link::steady_now() >= search.until;
    return failure ? nullptr : std::move(attempt);
  };
  const auto listen_with_each = [&](const std::vector<Setting>& settings) {
    for (std::size_t i = 0; i < settings.size() && !over; ++i)
      if (auto attempt = listen(settings[i])) attempts.push_back(std::move(attempt));
  };
  // Nearly all sensors show with 8N1, and so do all with 7 data bits. So parity comes last.
  listen_with_each(plain);
  for (auto& attempt : attempts) {
    if (over || !attempt->hearing().slight()) continue;
    if (auto again = listen(attempt->setting())) attempt = std::move(again);
  }
  if (serial && !fixed_parity) listen_with_each(settings_of(search.link, "EO"));
  if (attempts.empty()) return false;
  std::ranges::stable_sort(attempts, {}, [](const auto& a) { return a->hearing().confidence(); });
  // Only the devices of the best attempt are real: the same sensor at another rate is noise.
  for (const auto& attempt : attempts) {
    report.devices.clear();
    attempt->report_into(report);
  }
  return true;
}

}  // namespace drydock::probe
