#include <fmt/format.h>

#include "drivers/doctor/holders.hpp"
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

template <class F>
void visit_fields(const Holder& h, F&& field) {
  field("name", h.name);
  field("process", h.process);
}

}  // namespace drydock::doctor

namespace drydock::probe {

namespace {

/// A serial port with what a user must know before opening it.
struct ListedPort {
  doctor::SerialPort port;
  doctor::PortAccess access;
  std::vector<doctor::Holder> users;
};

template <class F>
void visit_fields(const ListedPort& p, F&& field) {
  visit_fields(p.port, field);
  field("allowed", p.access.allowed);
  field("mode", p.access.mode);
  field("group", p.access.group);
  field("users", p.users);
}

std::vector<ListedPort> listed_ports(const std::string& root) {
  std::vector<ListedPort> all;
  for (auto& port : doctor::serial_ports(root)) {
    ListedPort listed{{}, doctor::access_of(root, port.path), doctor::holders_of(root, port.path)};
    listed.port = std::move(port);
    all.push_back(std::move(listed));
  }
  return all;
}

void print(const ListedPort& listed, std::FILE* out) {
  const auto& p = listed.port;
  fmt::print(out, "  {:<14} {:<12} {:<10} {}\n", p.path, p.driver, p.usb_id, p.product);
  fmt::print(out, "    {}, mode {}, group {}; {}\n",
             listed.access.allowed ? "you may open it" : "you may NOT open it (drydock doctor)",
             listed.access.mode, listed.access.group,
             listed.users.empty() ? "no program that we may see has it open"
                                  : "open in " + doctor::in_words(listed.users));
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
  const auto serial = listed_ports(root);
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
