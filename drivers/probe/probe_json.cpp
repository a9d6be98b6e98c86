#include "drivers/probe/probe_report.hpp"
#include "drivers/survey/node_names.hpp"
#include "drivers/text/json_lines.hpp"

namespace drydock::survey {

// The parts of the report as JSON. The names are those of the text.

template <class F>
void visit_fields(const MessageCount& m, F&& field) {
  field("type", m.type);
  field("count", m.count);
  field("rate_hz", m.rate_hz);
}

template <class F>
void visit_fields(const NameCount& u, F&& field) {
  field("name", u.name);
  field("count", u.count);
}

template <class F>
void visit_fields(const ByteFinding& f, F&& field) {
  field("protocol", f.protocol);
  field("confidence", to_string(f.confidence));
  field("good_frames", f.proofs);
  field("bad_frames", f.bad_checksums);
  field("bytes", f.bytes);
  field("explained", f.explained());
  field("messages", f.messages);
  field("unread", f.unread);
}

template <class F>
void visit_fields(const Traffic& t, F&& field) {
  field("id", t.number);
  field("frames", t.frames);
  field("rate_hz", t.rate_hz);
}

template <class F>
void visit_fields(const Complaint& c, F&& field) {
  field("error", c.text);
  field("frames", c.frames);
}

template <class F>
void visit_fields(const FoundDevice& d, F&& field) {
  field("name", d.name);
  field("kind", to_string(d.kind));
  field("protocol", d.protocol);
  field("link", d.link);
  field("rate_hz", d.rate_hz);
  field("address", d.address);
  if (!d.evidence.empty()) field("evidence", d.evidence);
  field("block", survey::rig_block(d));
}

std::string_view to_string(survey::NodeKind kind) {
  switch (kind) {
    case survey::NodeKind::described: return "described";
    case survey::NodeKind::j1939: return "j1939";
    case survey::NodeKind::canopen: return "canopen";
    case survey::NodeKind::plain: return "plain";
  }
  return {};
}

template <class F>
void visit_fields(const Node& n, F&& field) {
  field("kind", to_string(n.kind));
  if (!n.bus.empty()) field("bus", n.bus);
  field("address", n.address);
  field("frames", n.frames);
  field("confidence", to_string(n.confidence));
  field("name", n.name);
  field("name_in_words", n.name ? std::optional{survey::in_words(*n.name)} : std::nullopt);
  field("state", n.state ? std::optional{wire::canopen::to_string(*n.state)} : std::nullopt);
  field("booted", n.booted);
  field("emergency", n.emergency);
  field("device_type", n.device_type);
  field("vendor_id", n.vendor_id);
  field("product_code", n.product_code);
  if (!n.title.empty()) field("title", n.title);
  if (!n.also.empty()) field("also", n.also);
  field("traffic", n.traffic);
}

}  // namespace drydock::survey

namespace drydock::probe {

template <class F>
void visit_fields(const LineAttempt& a, F&& field) {
  field("setting", a.setting);
  field("link", a.link);
  field("bytes", a.bytes);
  field("findings", a.findings);
}

template <class F>
void visit_fields(const BusTraffic& b, F&& field) {
  field("bus", b.bus);
  field("frames", b.frames);
  field("bits_per_second", b.bits_per_second);
}

void print_json(const ProbeReport& report, std::FILE* out) {
  text::JsonLines lines(out);
  lines.line([&](text::JsonWriter& json) {
    json.field("link", report.link);
    json.field("listened_s", report.listened_s);
    json.field("interrupted", report.interrupted);
    json.field("confidence", to_string(report.confidence()));
    json.field("attempts", report.attempts);
    json.field("frames", report.frames);
    json.field("bits_per_second", report.bits_per_second);
    json.field("bitrate", report.bitrate);
    if (!report.buses.empty()) json.field("buses", report.buses);
    json.field("nodes", report.nodes);
    json.field("errors", report.complaints);
    json.field("notes", all_notes(report));
    json.field("problems", problems_of(report));
    json.field("devices", report.devices);
  });
  lines.flush();
}

}  // namespace drydock::probe
