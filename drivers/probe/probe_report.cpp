#include "drivers/probe/probe_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/survey/node_names.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::probe {

namespace {

using survey::Confidence;
using survey::Node;
using survey::NodeKind;

std::string rate_text(std::optional<double> rate_hz) {
  return rate_hz ? fmt::format(" at {:.3g} Hz", *rate_hz) : std::string();
}

void print_finding(const survey::ByteFinding& found, std::string_view of, std::FILE* out) {
  fmt::print(out, "  {}: {} ({}): {}\n", of, found.protocol, to_string(found.confidence),
             survey::reasons(found));
}

void print_messages(const survey::ByteFinding& found, std::FILE* out) {
  for (const auto& m : found.messages)
    fmt::print(out, "    {:<10} {:>6}{}\n", m.type, m.count, rate_text(m.rate_hz));
}

/// The findings that make devices: the first, and others that read what it passes over.
std::vector<const survey::ByteFinding*> used_findings(const LineAttempt& attempt) {
  const auto sensors = survey::sensors_of(attempt.findings);
  std::vector<const survey::ByteFinding*> used{&attempt.findings.front()};
  for (const auto& finding : attempt.findings)
    if (used.front() != &finding &&
        std::ranges::find(sensors, finding.protocol, &survey::SensorHeard::protocol) !=
            sensors.end())
      used.push_back(&finding);
  return used;
}

void print_attempt(const LineAttempt& attempt, bool in_full, std::FILE* out) {
  const std::string setting =
      attempt.setting.empty() ? "the line" : text::printable(attempt.setting);
  if (attempt.findings.empty()) {
    fmt::print(out, "  {}: {} bytes, no frame of any protocol\n", setting, attempt.bytes);
    return;
  }
  const auto& best = attempt.findings.front();
  print_finding(best, setting, out);
  if (!in_full) return;
  print_messages(best, out);
  const auto used = used_findings(attempt);
  for (const auto* other : used) {
    if (other == &best) continue;
    print_finding(*other, "and of the same bytes", out);
    print_messages(*other, out);
  }
  for (const auto& u : best.unread)
    if (std::ranges::none_of(used, [&](const auto* one) { return has_name(one->read, u.name); }))
      fmt::print(out, "    {:<10} {:>6}, not used\n", u.name, u.count);
}

std::string device_type_text(std::uint32_t device_type) {
  const auto profile = survey::canopen_profile(device_type);
  return fmt::format("{:08X}h", device_type) + (profile.empty() ? "" : " (" + profile + ")");
}

std::string node_title(const survey::Node& n) {
  switch (n.kind) {
    case survey::NodeKind::j1939:
      return fmt::format(
          "source address {}{}", n.address,
          n.name ? ": " + survey::in_words(*n.name) : std::string(": no address claim heard"));
    case survey::NodeKind::canopen: {
      std::string title = fmt::format("CANopen node {}", n.address);
      if (n.booted) title += ", booted";
      if (n.state) title += fmt::format(", {}", wire::canopen::to_string(*n.state));
      if (n.device_type) title += ", device type " + device_type_text(*n.device_type);
      if (n.vendor_id) title += fmt::format(", vendor {:08X}h", *n.vendor_id);
      if (n.product_code) title += fmt::format(", product {:08X}h", *n.product_code);
      return title;
    }
    case survey::NodeKind::plain: return "identifiers of no node";
    case survey::NodeKind::described: return text::printable(n.title);
  }
  return {};
}

void print_node(const survey::Node& n, std::FILE* out) {
  fmt::print(out, "  {}\n", node_title(n));
  if (n.emergency && n.emergency->code != 0)
    fmt::print(out, "    emergency {:04X}h: {}\n", n.emergency->code,
               wire::canopen::error_text(n.emergency->code));
  for (const auto& sensor : n.sensors)
    fmt::print(out, "    {} ({}, {}): {} measurements{}\n", to_string(sensor.kind), sensor.protocol,
               to_string(n.confidence), sensor.measurements, rate_text(sensor.rate_hz));
  for (const auto& sensor : n.sensors)
    if (!sensor.evidence.empty())
      fmt::print(out, "    {}: {}\n", text::printable(sensor.protocol),
                 text::printable(sensor.evidence));
  for (const auto& also : n.also) fmt::print(out, "    {}\n", text::printable(also));
  for (const auto& t : n.traffic) {
    const auto number = n.kind == survey::NodeKind::j1939 ? fmt::format("PGN {}", t.number)
                                                          : fmt::format("id {:03X}h", t.number);
    fmt::print(out, "    {:<12} {:>6} frames{}\n", number, t.frames, rate_text(t.rate_hz));
  }
}

void print_bus(const ProbeReport& report, std::FILE* out) {
  if (report.frames == 0 && report.nodes.empty() && report.complaints.empty()) return;
  fmt::print(out, "  {} frames", report.frames);
  if (report.bits_per_second) {
    fmt::print(out, ", {:.1f} kbit/s", *report.bits_per_second / 1000);
    if (report.bitrate)
      fmt::print(out, " = {:.1f} % of {} bit/s", 100 * *report.bits_per_second / *report.bitrate,
                 *report.bitrate);
  }
  fmt::print(out, "\n");
  for (const auto& c : report.complaints) fmt::print(out, "  {} x {}\n", c.frames, c.text);
  for (const auto& node : report.nodes) print_node(node, out);
}

void print_buses(const ProbeReport& report, std::FILE* out) {
  for (const auto& c : report.complaints) fmt::print(out, "  {} x {}\n", c.frames, c.text);
  for (const auto& bus : report.buses) {
    fmt::print(out, "  {}: {} frames{}\n", text::printable(bus.bus), bus.frames,
               bus.bits_per_second ? fmt::format(", {:.1f} kbit/s", *bus.bits_per_second / 1000)
                                   : std::string());
    for (const auto& node : report.nodes)
      if (node.bus == bus.bus) print_node(node, out);
  }
}

/// Of the settings of one port the last is the best; lines of a file all count.
bool counts(const ProbeReport& report, std::size_t attempt) {
  return report.has_lines || attempt + 1 == report.attempts.size();
}

std::string shared_text(const ProbeReport& report) {
  return "each reads a part of the bytes: also open in " + report.shared_with;
}

}  // namespace

std::vector<std::string> all_notes(const ProbeReport& report) {
  auto notes = report.recording;
  notes.insert(notes.end(), report.notes.begin(), report.notes.end());
  return notes;
}

survey::Confidence ProbeReport::confidence() const {
  survey::Confidence best = survey::Confidence::nothing;
  for (const auto& attempt : attempts)
    if (!attempt.findings.empty()) best = std::max(best, attempt.findings.front().confidence);
  for (const auto& node : nodes)
    best = std::max({best, node.confidence, node.frames > 0 ? survey::Confidence::trace : best});
  return best;
}

std::vector<std::string> problems_of(const ProbeReport& report) {
  std::vector<std::string> problems;
  if (!report.opened) return {report.notes.empty() ? "cannot open it" : report.notes.back()};
  if (report.confidence() == Confidence::nothing) problems.emplace_back("nothing was found");
  for (std::size_t i = 0; i < report.attempts.size(); ++i) {
    if (!counts(report, i) || report.attempts[i].findings.empty()) continue;
    const auto& best = report.attempts[i].findings.front();
    // Listening may have begun inside a frame; that one is not counted.
    if (best.bad_checksums > 1 + (best.proofs + best.bad_checksums) / 10)
      problems.push_back(fmt::format("{} of {} frames of {} are damaged", best.bad_checksums,
                                     best.proofs + best.bad_checksums, best.protocol));
  }
  if (!report.shared_with.empty()) problems.push_back(shared_text(report));
  for (const auto& c : report.complaints)
    problems.push_back(fmt::format("{} error frames: {}", c.frames, c.text));
  for (const Node& n : report.nodes)
    if (n.emergency && n.emergency->code != 0)
      problems.push_back(fmt::format(
          "{}{}: emergency {:04X}h: {}", n.bus.empty() ? "" : n.bus + ": ", node_title(n),
          n.emergency->code, wire::canopen::error_text(n.emergency->code)));
  return problems;
}

void print_text(const ProbeReport& report, std::FILE* out) {
  fmt::print(out, "{}: listened for {:.1f} s{}\n", text::printable(report.link), report.listened_s,
             report.interrupted ? ", interrupted" : "");
  for (std::size_t i = 0; i < report.attempts.size(); ++i)
    print_attempt(report.attempts[i], counts(report, i), out);
  report.buses.empty() ? print_bus(report, out) : print_buses(report, out);
  if (!report.shared_with.empty()) fmt::print(out, "  {}\n", text::printable(shared_text(report)));
  for (const auto& note : all_notes(report)) fmt::print(out, "  {}\n", text::printable(note));
  if (!report.devices.empty()) fmt::print(out, "\n# for a rig file:\n");
  for (const auto& device : report.devices)
    fmt::print(out, "\n{}", text::printable_lines(survey::rig_block(device)));
}

}  // namespace drydock::probe
