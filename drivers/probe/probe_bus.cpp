#include "drivers/probe/probe_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "drivers/link/can/can_interface.hpp"
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
      if (node.kind != survey::NodeKind::canopen) continue;
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
  if (!found->state.empty())
    report.notes.push_back(fmt::format("the controller is {}", found->state));
}

}  // namespace

void note_bus(const survey::BusSurvey& survey, const std::string& link, ProbeReport& report) {
  report.frames = survey.frames();
  report.nodes = survey.nodes();
  report.complaints = survey.complaints();
  report.bits_per_second = survey.bits_per_second();
  if (auto hint = survey::bit_rate_hint(report.complaints, report.frames); !hint.empty())
    report.notes.push_back(std::move(hint));
  for (const survey::Node& node : report.nodes)
    for (const auto& sensor : node.sensors)
      report.devices.push_back(
          {"", sensor.kind, std::string(sensor.protocol), link, sensor.rate_hz, node.address});
  survey::name_devices(report.devices);
}

bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report) {
  const auto uri = link::parse_uri(search.link).value();
  auto opened = link::open_frames(ear.executor(), uri, link::Side::driver);
  if (!opened) {
    report.notes.push_back(opened.error().message);
    return false;
  }
  survey::BusSurvey survey;
  Asker asker;
  ear.listen(**opened, search.until, [&](const wire::CanFrame* frame, Stamp at) {
    if (frame != nullptr) {
      survey.receive(*frame, at);
      return false;
    }
    if (search.ask) asker.ask(**opened, ear, survey);
    progress.show(fmt::format(
        "{}: {} frames; {:.0f} s left, Ctrl-C ends with what was found", search.link,
        survey.frames(), std::max(0.0, measurement::seconds(search.until - link::steady_now()))));
    return false;
  });
  if (!ear.trouble().empty()) report.notes.push_back("the bus ended: " + ear.trouble());
  note_interface(uri, report);
  note_bus(survey, search.link, report);
  return true;
}

}  // namespace drydock::probe
