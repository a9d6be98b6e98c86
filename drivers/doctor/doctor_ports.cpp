#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "drivers/doctor/doctor.hpp"
#include "drivers/doctor/holders.hpp"
#include "drivers/doctor/ports.hpp"

namespace drydock::doctor {
namespace {

namespace fs = std::filesystem;

/// The user and groups of this process, from /proc/self/status.
struct Identity {
  unsigned user = 0;
  std::set<unsigned> groups;
};

Identity identity(const std::string& root) {
  Identity who;
  std::ifstream in(fs::path(root) / "proc/self/status");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    unsigned real = 0, effective = 0;
    words >> key;
    if (key == "Uid:" && words >> real >> effective) who.user = effective;
    if (key == "Gid:" && words >> real >> effective) who.groups.insert(effective);
    if (key == "Groups:")
      for (unsigned group; words >> group;) who.groups.insert(group);
  }
  return who;
}

/// The name in /etc/group, or the number if the group has no name.
std::string group_name(const std::string& root, unsigned number) {
  std::ifstream in(fs::path(root) / "etc/group");
  for (std::string line; std::getline(in, line);) {
    const auto name = line.find(':'), id = line.find(':', name + 1);
    if (id != std::string::npos && std::atol(line.c_str() + id + 1) == static_cast<long>(number))
      return line.substr(0, name);
  }
  return std::to_string(number);
}

/// The ports that a rig names, otherwise all ports with hardware.
std::vector<std::string> ports_of(const std::string& root, const Needs& needs) {
  if (!needs.whole_machine) return needs.ports;
  std::vector<std::string> paths;
  for (const auto& port : serial_ports(root)) paths.push_back(port.path);
  return paths;
}

Diagnosis check_port(const std::string& root, const std::string& path, const Identity& who) {
  struct stat info {};
  if (::stat((root + path).c_str(), &info) != 0)
    return {"permissions", Fitness::wrong, path + " is not there: is it plugged in?",
            "drydock probe --all"};
  const bool ours = info.st_uid == who.user && (info.st_mode & S_IRUSR) && (info.st_mode & S_IWUSR);
  const bool by_group =
      who.groups.contains(info.st_gid) && (info.st_mode & S_IRGRP) && (info.st_mode & S_IWGRP);
  const bool by_all = (info.st_mode & S_IROTH) && (info.st_mode & S_IWOTH);
  if (who.user == 0 || ours || by_group || by_all)
    return {"permissions", Fitness::ok, path + " may be read and written", ""};
  const std::string group = group_name(root, info.st_gid);
  const bool for_a_group = (info.st_mode & S_IRGRP) && (info.st_mode & S_IWGRP);
  if (group == "root" || !for_a_group)
    return {"permissions", Fitness::wrong, path + " is for root alone: no rule gave it to a group",
            fmt::format("sudo chgrp dialout {0} && sudo chmod g+rw {0}  # until it is plugged in "
                        "again; a udev rule does it for good",
                        path)};
  return {"permissions", Fitness::wrong,
          fmt::format("{} belongs to the group {}, and you do not", path, group),
          fmt::format("sudo usermod -aG {} $USER  # then log in again", group)};
}

/// The name of every process, by its number.
std::map<std::string, std::string> processes(const std::string& root) {
  std::map<std::string, std::string> names;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(fs::path(root) / "proc", gone)) {
    const auto number = entry.path().filename().string();
    if (!std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; }))
      continue;
    std::ifstream in(entry.path() / "comm");
    std::getline(in, names[number]);
  }
  return names;
}

/// Programs that open serial ports which nobody gave them, when an adapter is plugged in.
struct Grabber {
  const char *name, *text, *command;
};
constexpr std::array grabbers{
    Grabber{"ModemManager", "ModemManager runs: it tries new serial ports for modems",
            "sudo systemctl mask --now ModemManager"},
    Grabber{"brltty",
            "brltty runs: it takes new serial adapters (CH340, CP210x) for braille displays",
            "sudo systemctl mask --now brltty.service brltty-udev.service"}};

/// One word for a shell, whatever the name of the file is.
std::string in_shell_quotes(const std::string& name) {
  std::string quoted = "'";
  for (const char c : name)
    if (c == '\'')
      quoted += R"('\'')";
    else
      quoted += c;
  return quoted + "'";
}

}  // namespace

PortAccess access_of(const std::string& root, const std::string& path) {
  struct stat info {};
  if (::stat((root + path).c_str(), &info) != 0) return {};
  const bool allowed = check_port(root, path, identity(root)).fitness == Fitness::ok;
  return {allowed, fmt::format("{:03o}", info.st_mode & 0777U), group_name(root, info.st_gid)};
}

std::vector<Diagnosis> check_ports(const std::string& root, const Needs& needs) {
  const Identity who = identity(root);
  std::vector<Diagnosis> found;
  for (const auto& path : ports_of(root, needs)) found.push_back(check_port(root, path, who));
  if (found.empty() && needs.whole_machine)
    found.push_back({"permissions", Fitness::ok, "there is no serial port", ""});
  return found;
}

std::vector<Diagnosis> check_holders(const std::string& root, const Needs& needs) {
  std::vector<Diagnosis> found;
  const auto ports = ports_of(root, needs);
  for (const auto& port : ports)
    for (const auto& [name, process] : holders_of(root, port))
      found.push_back(
          {"other programs", Fitness::wrong,
           fmt::format("{} (process {}) has {} open", name, process, port),
           name == "gpsd" ? "sudo systemctl stop gpsd.socket gpsd" : "kill " + process});
  for (const auto& [process, name] : processes(root)) {
    if (ports.empty()) continue;
    for (const auto& program : grabbers)
      if (name == program.name)
        found.push_back({"other programs", Fitness::advice, program.text, program.command});
  }
  if (found.empty() && !ports.empty())
    found.push_back({"other programs", Fitness::ok, "none that we may see holds a port", ""});
  return found;
}

std::vector<Diagnosis> check_names(const std::string& root, const Needs& needs) {
  if (needs.whole_machine) return {};  // `drydock probe --all` lists both names of each port
  std::vector<Diagnosis> found;
  for (const auto& port : serial_ports(root))
    if (!port.by_id.empty() && std::ranges::find(needs.ports, port.path) != needs.ports.end())
      found.push_back(
          {"names", Fitness::advice,
           fmt::format("{} may be another adapter after the next plugging; its name that stays is "
                       "{}",
                       port.path, port.by_id),
           needs.rig_file.empty() ? std::string()
                                  : fmt::format(R"(sed -i 's|{}\b|{}|' {})", port.path, port.by_id,
                                                in_shell_quotes(needs.rig_file))});
  return found;
}

std::vector<Diagnosis> check_latency(const std::string& root, const Needs& needs) {
  std::vector<Diagnosis> found;
  for (const auto& port : ports_of(root, needs)) {
    const auto tty = fs::path(real_path(root, port)).filename().string();
    const std::string file = "/sys/bus/usb-serial/devices/" + tty + "/latency_timer";
    std::ifstream in(root + file);
    int ms = 0;
    if (!(in >> ms)) continue;  // only FTDI chips have this setting
    if (ms <= 1)
      found.push_back({"latency", Fitness::ok, port + " hands bytes over within 1 ms", ""});
    else
      found.push_back({"latency", Fitness::advice,
                       fmt::format("{} keeps bytes for up to {} ms until a driver of ours asks for "
                                   "less",
                                   port, ms),
                       fmt::format("echo 1 | sudo tee {}", file)});
  }
  return found;
}

}  // namespace drydock::doctor
