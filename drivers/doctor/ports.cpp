#include "drivers/doctor/ports.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "drivers/link/can/can_interface.hpp"

namespace drydock::doctor {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// The names of the entries in a folder, sorted. Empty if it cannot be read.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(folder, gone))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// Reads the USB device of a port: the nearest folder above it that has an idVendor.
void read_usb(const fs::path& device, const fs::path& top, SerialPort& port) {
  for (auto folder = device; folder.has_relative_path() && folder != top;
       folder = folder.parent_path()) {
    const auto vendor = first_line(folder / "idVendor");
    if (vendor.empty()) continue;
    port.usb_id = vendor + ":" + first_line(folder / "idProduct");
    port.product = first_line(folder / "product");
    return;
  }
}

std::string by_id_of(const fs::path& root, const std::string& tty) {
  const auto folder = root / "dev/serial/by-id";
  for (const auto& name : names_in(folder)) {
    std::error_code gone;
    if (fs::read_symlink(folder / name, gone).filename() == tty) return "/dev/serial/by-id/" + name;
  }
  return {};
}

}  // namespace

std::vector<SerialPort> serial_ports(const std::string& root) {
  const fs::path top(root);
  std::vector<SerialPort> ports;
  for (const auto& tty : names_in(top / "sys/class/tty")) {
    std::error_code gone;
    const auto device = fs::canonical(top / "sys/class/tty" / tty / "device", gone);
    if (gone) continue;  // a console or a pty: it has no hardware
    SerialPort port;
    port.path = "/dev/" + tty;
    port.driver = fs::canonical(device / "driver", gone).filename().string();
    // The 8250 driver always shows four ports. A port of type 0 has no chip.
    if (first_line(top / "sys/class/tty" / tty / "type") == "0") continue;
    port.by_id = by_id_of(top, tty);
    read_usb(device, top, port);
    ports.push_back(std::move(port));
  }
  return ports;
}

std::vector<CanPort> can_ports(const std::string& root) {
  constexpr std::string_view arphrd_can = "280";
  std::vector<CanPort> ports;
  for (const auto& name : names_in(fs::path(root) / "sys/class/net")) {
    const auto folder = fs::path(root) / "sys/class/net" / name;
    if (first_line(folder / "type") != arphrd_can) continue;
    CanPort port{
        name, first_line(folder / "operstate") != "down", name.starts_with("vcan"), {}, {}};
    if (root == "/") {
      if (const auto found = link::find_can_interface(name)) {
        port.up = found->up;
        port.is_virtual = found->is_vcan;
        port.state = found->state;
        port.bitrate = found->bitrate;
      }
    }
    ports.push_back(std::move(port));
  }
  return ports;
}

}  // namespace drydock::doctor
