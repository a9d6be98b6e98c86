#include <fmt/format.h>
#include <sys/statvfs.h>
#include <sys/timex.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "drivers/doctor/doctor.hpp"
#include "drivers/doctor/ports.hpp"
#include "drivers/link/can/interface_commands.hpp"

namespace drydock::doctor {
namespace {

namespace fs = std::filesystem;

/// True if the module is loaded or built into the kernel.
bool has_module(const std::string& root, const std::string& name) {
  if (fs::exists(fs::path(root) / "sys/module" / name)) return true;
  std::ifstream release_file(fs::path(root) / "proc/sys/kernel/osrelease");
  std::string release;
  std::getline(release_file, release);
  std::ifstream builtin(fs::path(root) / "lib/modules" / release / "modules.builtin");
  std::string file = name;
  std::ranges::replace(file, '_', '-');  // can-raw.ko holds the module can_raw
  for (std::string line; std::getline(builtin, line);)
    if (line.ends_with("/" + file + ".ko") || line.ends_with("/" + name + ".ko")) return true;
  return false;
}

Diagnosis check_module(const std::string& root, const std::string& name, bool needed,
                       const std::string& what_for) {
  if (has_module(root, name)) return {"modules", Fitness::ok, name + " is there: " + what_for, ""};
  return {"modules", needed ? Fitness::wrong : Fitness::advice,
          name + " is not loaded: " + what_for, "sudo modprobe " + name};
}

/// Linux gives a CAN interface a queue of 10 frames: a burst of two devices fills it.
std::optional<Diagnosis> check_queue(const std::string& root, const std::string& name) {
  constexpr unsigned too_short = 100, enough = 1000;
  std::ifstream in(fs::path(root) / "sys/class/net" / name / "tx_queue_len");
  unsigned frames = 0;
  if (!(in >> frames) || frames >= too_short) return {};
  return Diagnosis{
      "CAN", Fitness::advice,
      fmt::format("{} queues {} frames: on a busy bus, sending fails with 'no buffer space'", name,
                  frames),
      fmt::format("sudo ip link set {} txqueuelen {}", name, enough)};
}

Diagnosis check_bus(const std::string& root, const std::string& name, const Needs& needs,
                    const std::vector<CanPort>& ports) {
  const auto port = std::ranges::find(ports, name, &CanPort::name);
  const bool is_virtual = name.starts_with("vcan");
  constexpr unsigned usual_bitrate = 250000;  // of NMEA 2000 and J1939
  std::optional<unsigned> wanted;
  if (needs.bitrates.contains(name)) wanted = needs.bitrates.at(name);
  if (port == ports.end())
    return {"CAN", Fitness::wrong, "there is no CAN interface " + name,
            is_virtual ? fmt::format("sudo ip link add {} type vcan && {}", name,
                                     link::command_to_set_up_virtual(name))
                       : "ip -details link show type can"};
  if (!port->up)
    return {"CAN", Fitness::wrong, name + " is down",
            is_virtual ? link::command_to_set_up_virtual(name)
                       : link::command_to_set_up(name, wanted.value_or(usual_bitrate), root)};
  if (port->state == "BUS-OFF")
    return {"CAN", Fitness::wrong, name + " is bus-off: it takes no part in the bus",
            link::command_to_restart(name)};
  if (wanted && port->bitrate && *port->bitrate != *wanted)
    return {"CAN", Fitness::wrong,
            fmt::format("{} runs at {} bit/s, the rig says {}", name, *port->bitrate, *wanted),
            link::command_to_set_up(name, *wanted, root)};
  const std::string rate = port->bitrate ? fmt::format(" at {} bit/s", *port->bitrate) : "";
  return {"CAN", Fitness::ok, name + " is up" + rate, ""};
}

constexpr unsigned multicast_flag = 0x1000;  // IFF_MULTICAST

}  // namespace

std::vector<Diagnosis> check_can(const std::string& root, const Needs& needs) {
  std::vector<Diagnosis> found;
  const bool any = needs.whole_machine || needs.kernel_can || needs.can_auto;
  if (!any) return found;
  found.push_back(check_module(root, "can", needs.kernel_can, "CAN in the kernel"));
  found.push_back(check_module(root, "can_raw", needs.kernel_can, "socketcan: links"));
  const bool needs_vcan = std::ranges::any_of(
      needs.buses, [](const std::string& bus) { return bus.starts_with("vcan"); });
  found.push_back(check_module(root, "vcan", needs_vcan,
                               "virtual buses; can:auto does with slcan on a pty where it is not"));
  if (needs.whole_machine) {
    found.push_back(check_module(root, "can_j1939", false, "only for other programs on the bus"));
    found.push_back(
        check_module(root, "slcan", false, "only for slcand; slcan: links of ours do without"));
  }
  const auto ports = can_ports(root);
  auto buses = needs.buses;
  if (needs.whole_machine)
    for (const auto& port : ports) buses.push_back(port.name);
  for (const auto& bus : buses) {
    found.push_back(check_bus(root, bus, needs, ports));
    if (const auto queue = check_queue(root, bus)) found.push_back(*queue);
  }
  return found;
}

std::vector<Diagnosis> check_network(const std::string& root, const Needs& needs) {
  if (!needs.dds) return {};
  std::ifstream in(fs::path(root) / "sys/class/net/lo/flags");
  std::string text;
  in >> text;
  const auto flags = std::strtoul(text.c_str(), nullptr, 16);
  if (text.empty()) return {{"DDS", Fitness::wrong, "there is no loopback interface", ""}};
  if ((flags & 1) == 0)
    return {{"DDS", Fitness::wrong, "the loopback interface is down", "sudo ip link set lo up"}};
  if ((flags & multicast_flag) == 0)
    return {{"DDS", Fitness::advice,
             "the loopback interface carries no multicast: ours do without, other DDS programs on "
             "this machine may not find each other",
             "sudo ip link set lo multicast on"}};
  return {{"DDS", Fitness::ok, "the loopback interface carries multicast", ""}};
}

std::vector<Diagnosis> check_disk(const std::string& folder) {
  struct statvfs info {};
  if (::statvfs(folder.c_str(), &info) != 0)
    return {{"disk", Fitness::wrong, "cannot look at " + folder, ""}};
  const double free_mb =
      static_cast<double>(info.f_bavail) * static_cast<double>(info.f_frsize) / 1e6;
  constexpr double too_little_mb = 100, little_mb = 2000;
  const auto fitness = free_mb < too_little_mb ? Fitness::wrong
                       : free_mb < little_mb   ? Fitness::advice
                                               : Fitness::ok;
  return {{"disk", fitness, fmt::format("{:.1f} GB are free here for recordings", free_mb / 1000),
           fitness == Fitness::ok ? "" : "df -h ."}};
}

std::vector<Diagnosis> check_clock(int code, int status) {
  if (code == -1)
    return {{"clock", Fitness::advice, "the kernel does not say how the clock is", ""}};
  if (code == TIME_ERROR || (status & STA_UNSYNC) != 0)
    return {{"clock", Fitness::advice,
             "the clock follows no time server: stamps of two machines cannot be compared",
             "sudo timedatectl set-ntp true"}};
  return {{"clock", Fitness::ok, "the clock is synchronised", ""}};
}

}  // namespace drydock::doctor
