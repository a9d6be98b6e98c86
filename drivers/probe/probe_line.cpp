#include "drivers/probe/probe_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "drivers/link/clock.hpp"
#include "drivers/terminal/terminal_screen.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

namespace drydock::probe {
namespace {

using link::Stamp;
using survey::ByteSurvey;
using survey::Confidence;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

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

/// One line, decoded in three ways: as it is, and as 7 data bits with even or odd parity.
struct Hearing {
  explicit Hearing(const ByteSurvey::Descriptions& descriptions)
      : eight(descriptions), even(descriptions), odd(descriptions) {}

  survey::ByteSurvey eight, even, odd;
  /// A burst began after silence and has ended: its messages were heard completely.
  bool whole_burst = false;
  bool from_silence = true;
  std::uint64_t burst = 0;
  Stamp last_byte{};

  void feed(wire::Bytes bytes, Stamp at, bool seven_too) {
    if (burst == 0) from_silence = eight.bytes() == 0 || at - last_byte > 150ms;
    burst += bytes.size();
    last_byte = at;
    eight.feed(bytes, at);
    if (!seven_too) return;
    even.feed(survey::seven_bits(bytes, false), at);
    odd.feed(survey::seven_bits(bytes, true), at);
  }
  void pause(Stamp now) {
    constexpr std::uint64_t least = 16;
    if (burst == 0 || now - last_byte < 150ms) return;
    whole_burst |= burst >= least && from_silence;
    burst = 0;
  }
  bool settled() const { return eight.settled() || even.settled() || odd.settled(); }
  survey::Confidence confidence() const {
    return std::max({eight.best().confidence, even.best().confidence, odd.best().confidence});
  }
  /// True if more listening at this rate is useless. One accidental frame in noise does not count.
  bool hopeless(Stamp now, Stamp since) const {
    constexpr std::uint64_t many = 8192;
    constexpr double some = 0.5;
    const double explained =
        std::max({eight.best().explained(), even.best().explained(), odd.best().explained()});
    if (eight.bytes() == 0 || explained >= some) return false;
    const bool nothing = confidence() == survey::Confidence::nothing;
    return (nothing && whole_burst) || eight.bytes() > many || now - since > 3s;
  }
};

/// Questions that change nothing: UBX-MON-VER, and Water Linked's version. docs/pier/probe.md
std::vector<std::uint8_t> questions() {
  std::array<std::uint8_t, wire::ubx::overhead> poll;
  constexpr std::uint16_t mon_ver = 0x0A04;
  wire::ubx::wrap(poll, mon_ver, 0);
  std::vector<std::uint8_t> all(poll.begin(), poll.end());
  for (const char c : std::string_view("\r\nwcv\r\n")) all.push_back(static_cast<std::uint8_t>(c));
  return all;
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
      : search_(search), setting_(setting), serial_(serial), hearing_(search.descriptions) {}

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
      return hearing_.settled() || (may_leave && hearing_.hopeless(at, since));
    });
    note_ = (*opened)->note();
    return {};
  }

  const Hearing& hearing() const { return hearing_; }

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
    note_line(survey, serial_ ? in_words(heard, bits) : "",
              serial_ ? with_keys(search_.link, heard, bits) : search_.link, report);
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

/// First 8N1 at every rate, then parity. Nearly all sensors show with 8N1, and so do all with 7
/// data bits.
std::vector<Setting> settings_of(const std::string& uri) {
  const auto parsed = link::parse_uri(uri);
  const bool fixed_baud = uri.find("baud=") != std::string::npos;
  const bool fixed_parity = uri.find("parity=") != std::string::npos;
  std::vector<Setting> settings;
  for (const char parity : fixed_parity ? std::string("N") : std::string("NEO")) {
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
  if (shown_ > 0) fmt::print(err_, "\r\033[K");
  std::fflush(err_);
}

void Progress::show(const std::string& text) {
  if (!terminal_) return;
  fmt::print(err_, "\r\033[K{}", text);
  std::fflush(err_);
  ++shown_;
}

void note_line(const survey::ByteSurvey& survey, const std::string& setting,
               const std::string& link, ProbeReport& report) {
  LineAttempt attempt{setting, link, survey.bytes(), survey.findings()};
  for (const auto& finding : attempt.findings) {
    if (&finding != &attempt.findings.front()) break;
    for (const auto& sensor : finding.sensors)
      report.devices.push_back(
          {"", sensor.kind, std::string(finding.protocol), link, sensor.rate_hz, 0});
    if (finding.protocol == "slcan")
      report.notes.push_back("a serial CAN adapter that is open: probe slcan:" + link);
  }
  survey::name_devices(report.devices);
  report.attempts.push_back(std::move(attempt));
}

bool search_line(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report) {
  const bool serial = search.link.starts_with("serial:");
  const auto settings = serial ? settings_of(search.link) : std::vector<Setting>{{0, 'N'}};
  std::vector<std::unique_ptr<Attempt>> attempts;
  for (const Setting& setting : settings) {
    auto attempt = std::make_unique<Attempt>(search, setting, serial);
    const auto failure = attempt->run(ear, progress, settings.size() > 1);
    if (failure && attempts.empty()) {
      report.notes.push_back(failure->message);
      return false;
    }
    if (failure) continue;  // the port does not support this rate
    attempts.push_back(std::move(attempt));
    if (attempts.back()->hearing().settled() || ear.interrupted() ||
        link::steady_now() >= search.until)
      break;
  }
  std::ranges::stable_sort(attempts, {}, [](const auto& a) { return a->hearing().confidence(); });
  // Only the devices of the best attempt are real: the same sensor at another rate is noise.
  for (const auto& attempt : attempts) {
    report.devices.clear();
    attempt->report_into(report);
  }
  return true;
}

}  // namespace drydock::probe
