#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "drivers/doctor/doctor.hpp"

namespace drydock::doctor {
namespace {

namespace bus_fs = std::filesystem;

std::string text_of(const bus_fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// A device on a bus of this machine that no driver serves.
struct Orphan {
  std::string alias;  ///< what it is, as the kernel tells it: "usb:v0403p6001d0600..."
  std::string name;   ///< for people
};

/// A USB device tells its name in the folder above that of its interface.
std::string name_of(const bus_fs::path& device) {
  std::error_code gone;
  const auto product = text_of(bus_fs::canonical(device, gone).parent_path() / "product");
  const auto place = device.filename().string();
  return product.empty() ? "at " + place : fmt::format("\"{}\" at {}", product, place);
}

std::vector<Orphan> orphans(const std::string& root) {
  std::vector<Orphan> found;
  for (const char* bus : {"usb", "pci", "spi"}) {
    std::error_code none;
    for (const auto& device :
         bus_fs::directory_iterator(bus_fs::path(root) / "sys/bus" / bus / "devices", none)) {
      if (bus_fs::exists(device.path() / "driver")) continue;
      const auto alias = text_of(device.path() / "modalias");
      if (!alias.empty()) found.push_back({alias, name_of(device.path())});
    }
  }
  return found;
}

/// The module's name in the kernel: cdc-acm.ko.xz holds cdc_acm.
std::string module_in(const std::string& path) {
  auto name = path.substr(path.rfind('/') + 1);
  name.resize(name.find('.'));
  std::ranges::replace(name, '-', '_');
  return name;
}

/// The modules of this kernel that drive serial and CAN adapters, by their place in its tree.
std::set<std::string> adapter_modules(const bus_fs::path& folder) {
  constexpr std::array<std::string_view, 3> places{"/drivers/net/can/", "/drivers/usb/serial/",
                                                   "/drivers/usb/class/cdc-acm."};
  std::set<std::string> modules;
  std::ifstream in(folder / "modules.dep");
  for (std::string line; std::getline(in, line);) {
    const auto path = line.substr(0, line.find(':'));
    if (std::ranges::any_of(places, [&](auto place) { return path.find(place) != path.npos; }))
      modules.insert(module_in(path));
  }
  return modules;
}

}  // namespace

std::vector<Diagnosis> check_drivers(const std::string& root, const Needs& needs) {
  if (!needs.whole_machine && needs.ports.empty() && needs.buses.empty()) return {};
  const auto devices = orphans(root);
  if (devices.empty()) return {};
  const auto folder = bus_fs::path(root) / "lib/modules" /
                      text_of(bus_fs::path(root) / "proc/sys/kernel/osrelease");
  auto modules = adapter_modules(folder);
  std::vector<Diagnosis> found;
  std::ifstream in(folder / "modules.alias");  // lines: alias PATTERN MODULE
  for (std::string line; std::getline(in, line);) {
    const auto begin = line.find(' ') + 1, end = line.rfind(' ');
    if (begin > end) continue;
    const auto module = line.substr(end + 1);
    if (!modules.contains(module) || bus_fs::exists(bus_fs::path(root) / "sys/module" / module))
      continue;
    const auto pattern = line.substr(begin, end - begin);
    const auto device = std::ranges::find_if(devices, [&](const Orphan& orphan) {
      return ::fnmatch(pattern.c_str(), orphan.alias.c_str(), 0) == 0;
    });
    if (device == devices.end()) continue;
    found.push_back(
        {"modules", Fitness::advice,
         fmt::format("the adapter {} has no driver: {} is not loaded", device->name, module),
         "sudo modprobe " + module});
    modules.erase(module);  // one line each
  }
  return found;
}

}  // namespace drydock::doctor
