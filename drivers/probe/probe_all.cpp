#include <fmt/format.h>

#include "drivers/doctor/ports.hpp"
#include "drivers/probe/probe.hpp"
#include "drivers/text/json_lines.hpp"

namespace drydock::doctor {

template <class F>
void visit_fields(const SerialPort& p, F&& field) {
  field("path", p.path);
  field("by_id", p.by_id);
  field("driver", p.driver);
  field("usb_id", p.usb_id);
  field("product", p.product);
}

template <class F>
void visit_fields(const CanPort& p, F&& field) {
  field("name", p.name);
  field("up", p.up);
  field("virtual", p.is_virtual);
  field("state", p.state);
  field("bitrate", p.bitrate);
}

}  // namespace drydock::doctor

namespace drydock::probe {

namespace {

void print(const doctor::SerialPort& p, std::FILE* out) {
  fmt::print(out, "  {:<14} {:<12} {:<10} {}\n", p.path, p.driver, p.usb_id, p.product);
  if (!p.by_id.empty()) fmt::print(out, "    drydock probe serial:{}\n", p.by_id);
}

void print(const doctor::CanPort& p, std::FILE* out) {
  fmt::print(out, "  {:<14} {}{}{}{}\n", p.name, p.up ? "up" : "down",
             p.is_virtual ? ", virtual" : "",
             p.bitrate ? fmt::format(", {} bit/s", *p.bitrate) : std::string(),
             p.state.empty() ? std::string() : ", " + p.state);
}

}  // namespace

int probe_all(const std::string& root, bool json, std::FILE* out) {
  const auto serial = doctor::serial_ports(root);
  const auto can = doctor::can_ports(root);
  if (json) {
    text::JsonLines lines(out);
    lines.line([&](text::JsonWriter& writer) {
      writer.field("serial", serial);
      writer.field("can", can);
    });
    lines.flush();
    return 0;
  }
  fmt::print(out, "serial ports{}\n", serial.empty() ? ": none" : "");
  for (const auto& port : serial) print(port, out);
  fmt::print(out, "CAN interfaces{}\n", can.empty() ? ": none" : "");
  for (const auto& port : can) print(port, out);
  return 0;
}

}  // namespace drydock::probe
