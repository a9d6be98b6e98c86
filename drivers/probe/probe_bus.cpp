#include "drivers/probe/probe_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/can/slcan.hpp"
#include "drivers/link/can/slcan_trouble.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"

namespace drydock::probe {
namespace {

using link::Stamp;
using survey::Node;

/// Sends only questions that read. It asks for all NAMEs by PGN 59904. It asks each CANopen node
/// that it heard for its identity (objects 1000h, 1018h). It sends nothing before the first good
/// frame: at a wrong bit rate a question would disturb the bus.
class Asker {
 public:
  void ask(link::FrameLink& bus, Ear& ear, const survey::BusSurvey& survey) {
    if (survey.frames() == 0) return;
    if (!std::exchange(asked_names_, true)) {
      ear.say(bus, wire::j1939::encode(wire::j1939::Request{wire::j1939::null_address,
                                                            wire::j1939::global_address,
                                                            wire::j1939::address_claim_pgn}));
      return;  // one write at a time
    }
    for (const survey::Node& node : survey.nodes()) {
      if (node.kind != survey::NodeKind::canopen || node.only_described) continue;
      for (const auto entry : entries) {
        if (!asked_.insert({node.address, entry.index, entry.subindex}).second) continue;
        ear.say(bus, wire::canopen::encode(wire::canopen::SdoRead{node.address, entry}));
        return;
      }
    }
  }

 private:
  static constexpr std::array<wire::canopen::ObjectEntry, 3> entries{
      {{0x1000, 0}, {0x1018, 1}, {0x1018, 2}}};
  bool asked_names_ = false;
  std::set<std::tuple<std::uint8_t, std::uint16_t, std::uint8_t>> asked_;
};

void note_interface(const link::Uri& uri, ProbeReport& report) {
  if (uri.scheme != link::Scheme::socketcan) return;
  const auto found = link::find_can_interface(uri.target);
  if (!found) return;
  report.bitrate = found->bitrate;
  if (found->is_vcan) report.notes.push_back(uri.target + " is virtual: it has no bit rate");
  if (found->listen_only)
    report.notes.push_back(*found->listen_only
                               ? "the controller is listen-only"
                               : "nothing was sent, but the controller acknowledges frames");
  if (!found->state.empty())
    report.notes.push_back(fmt::format("the controller is {}", found->state));
}

/// Only an slcan adapter can be told a rate, and at a wrong one it must not be active.
bool searches_rate(const link::Uri& uri) {
  return uri.scheme == link::Scheme::slcan && uri.text_of("bitrate").empty();
}

std::string with_rate(const std::string& link, unsigned rate) {
  return fmt::format("{}{}bitrate={}", link, link.find('?') == std::string::npos ? '?' : '&', rate);
}

/// Listens to one bus, perhaps at several rates, into one survey. It opens every link listen-only;
/// with `ask` it opens the link once more to ask, after a sound frame.
class BusSearch {
 public:
  using Failure = std::optional<link::OpenError>;

  BusSearch(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report)
      : search_(search),
        ear_(ear),
        progress_(progress),
        report_(report),
        link_(search.link),
        survey_(search.descriptions) {}

  Failure listen(const link::Uri& uri) {
    auto failure = hear(link::listening(uri), search_.until);
    if (failure || !search_.ask || survey_.frames() == 0) return failure;
    asks_ = true;
    return hear(uri, search_.until);
  }

  /// Listens at each rate for an equal share of the time. It stays where it hears a frame.
  Failure search_rate(const link::Uri& uri) {
    const auto share = (search_.until - link::steady_now()) / link::slcan_search_order.size();
    Stamp leave_at = link::steady_now();
    Failure failure;
    for (const unsigned rate : link::slcan_search_order) {
      link::Uri with = uri;
      with.query["bitrate"] = std::to_string(rate);
      failure = hear(link::listening(with), leave_at += share);
      if (failure && !link::is_refused_rate(failure->code)) return failure;
      if (survey_.frames() > 0) return found(rate, with);
      if (ear_.interrupted()) break;
    }
    report_.notes.emplace_back("no frames at any rate from 10000 to 1000000 bit/s");
    return {};
  }

  void conclude() { note_bus(survey_, link_, report_); }

 private:
  Failure found(unsigned rate, const link::Uri& uri) {
    link_ = with_rate(search_.link, rate);
    report_.bitrate = rate;
    report_.notes.push_back(fmt::format("valid frames at {} bit/s", rate));
    if (!search_.ask) return {};
    asks_ = true;
    return hear(uri, search_.until);
  }

  /// Until the time of the search is over; without frames only until `leave_at`.
  Failure hear(const link::Uri& uri, Stamp leave_at) {
    auto opened = link::open_frames(ear_.executor(), uri, link::Side::driver);
    if (!opened) return opened.error();
    ear_.listen(**opened, search_.until, [&](const wire::CanFrame* frame, Stamp at) {
      if (frame != nullptr) {
        survey_.receive(*frame, at);
        return search_.ask && !asks_ && survey_.frames() > 0;
      }
      if (asks_) asker_.ask(**opened, ear_, survey_);
      progress_.show(progress_text(uri));
      return survey_.frames() == 0 && at >= leave_at;
    });
    note_link((*opened)->note());
    if (!ear_.failure()) return {};
    if (survey_.frames() == 0 && link::has_line_under(uri))
      return link::OpenError{ear_.failure(), ear_.trouble()};
    report_.notes.push_back("the bus ended: " + ear_.trouble());
    return {};
  }

  void note_link(std::string_view note) {
    if (!note.empty() && std::ranges::find(report_.notes, note) == report_.notes.end())
      report_.notes.emplace_back(note);
  }

  std::string progress_text(const link::Uri& uri) const {
    const auto rate = searches_rate(link::parse_uri(search_.link).value())
                          ? fmt::format(" at {} bit/s", *uri.bitrate())
                          : std::string();
    return fmt::format("{}{}: {} frames; {:.0f} s left, Ctrl-C ends with what was found",
                       search_.link, rate, survey_.frames(),
                       std::max(0.0, measurement::seconds(search_.until - link::steady_now())));
  }

  LineSearch search_;
  Ear& ear_;
  Progress& progress_;
  ProbeReport& report_;
  std::string link_;  ///< with the rate that was found
  survey::BusSurvey survey_;
  Asker asker_;
  bool asks_ = false;
};

}  // namespace

namespace {

void note_sensors(const survey::Node& node, const std::string& link, ProbeReport& report) {
  for (const auto& sensor : node.sensors)
    report.devices.push_back({"", sensor.kind, std::string(sensor.protocol), link, sensor.rate_hz,
                              node.address, sensor.description, sensor.evidence});
}

}  // namespace

void note_bus(const survey::BusSurvey& survey, const std::string& link, ProbeReport& report) {
  report.frames = survey.frames();
  report.nodes = survey.nodes();
  report.complaints = survey.complaints();
  report.bits_per_second = survey.bits_per_second();
  if (auto hint = survey::bit_rate_hint(report.complaints, report.frames); !hint.empty())
    report.notes.push_back(std::move(hint));
  for (const survey::Node& node : report.nodes) note_sensors(node, link, report);
  for (auto& text : survey.missed()) report.notes.push_back(std::move(text));
  survey::name_devices(report.devices);
}

void note_one_bus(const survey::BusSurvey& survey, const std::string& bus, const std::string& link,
                  ProbeReport& report) {
  report.frames += survey.frames();
  report.buses.push_back({bus, survey.frames(), survey.bits_per_second()});
  const auto complaints = survey.complaints();
  if (const auto hint = survey::bit_rate_hint(complaints, survey.frames()); !hint.empty())
    report.notes.push_back(bus + ": " + hint);
  for (const auto& one : complaints)
    report.complaints.push_back({bus + ": " + one.text, one.frames});
  for (survey::Node node : survey.nodes()) {
    if (!link.empty()) note_sensors(node, link, report);
    node.bus = bus;
    report.nodes.push_back(std::move(node));
  }
  for (const auto& text : survey.missed()) report.notes.push_back(bus + ": " + text);
  survey::name_devices(report.devices);
}

bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report) {
  const auto uri = link::parse_uri(search.link).value();
  BusSearch bus(search, ear, progress, report);
  if (const auto failure = searches_rate(uri) ? bus.search_rate(uri) : bus.listen(uri)) {
    report.notes.push_back(failure->message);
    return false;
  }
  note_interface(uri, report);
  bus.conclude();
  return true;
}

}  // namespace drydock::probe
