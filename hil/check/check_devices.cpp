#include "hil/check/check_devices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "drivers/link/can/frame_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "drivers/wire/described/read_back.hpp"

namespace drydock::check {

namespace {

namespace fs = std::filesystem;
using rig_config::Problems;

std::string path_of(std::size_t device, const std::string& key) {
  return fmt::format("/device/{}/{}", device, key);
}

/// Why a recording cannot be played. Empty if it can.
std::string why_unplayable(const link::Uri& uri, bool on_bus) {
  std::error_code error;
  if (!fs::is_regular_file(uri.target, error) && !fs::is_character_file(uri.target, error) &&
      !fs::is_fifo(uri.target, error))
    return "cannot open the recording " + uri.target + ": there is no such file";
  if (!on_bus || !fs::is_regular_file(uri.target, error)) return {};
  auto capture = link::capture_of(uri);
  capture.next();  // an unknown format shows at the first frame
  return capture.trouble();
}

/// A TCP server of the program is opened once, for all emulated devices behind it.
void check_one_server_each(const rig_config::Rig& rig, Problems& problems) {
  std::map<std::string, const rig_config::DeviceConfig*> owner;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& device = rig.devices[i];
    const auto uri = link::parse_uri(device.link);
    if (!uri || uri->scheme != link::Scheme::tcp || !uri->emulated()) continue;
    const auto* first = owner.emplace(uri->target, &device).first->second;
    if (first->link != device.link)
      problems.push_back(rig_config::problem_at(
          rig.places, path_of(i, "link"),
          fmt::format("tcp:{} is the server of '{}' too, which writes {}; emulated devices that "
                      "share a server write its link alike",
                      uri->target, first->name, first->link)));
  }
}

/// A node of a bus may be a sensor of several kinds; an emulated device is a node of its own.
void check_one_address_each(const rig_config::Rig& rig, Problems& problems) {
  std::map<std::pair<std::string, unsigned>, const rig_config::DeviceConfig*> owner;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& device = rig.devices[i];
    if (device.address == 0 || !is_emulated(device)) continue;
    const auto [first, fresh] = owner.emplace(std::pair(device.link, device.address), &device);
    if (!fresh && first->second->kind != device.kind)  // of one kind they are refused in any rig
      problems.push_back(rig_config::problem_at(
          rig.places, path_of(i, "address"),
          fmt::format("{} is already the address of '{}' on {}; each emulated device needs its own",
                      device.address, first->second->name, device.link)));
  }
}

/// A described device that is emulated and can write none of its messages is silent for ever.
void check_something_is_sent(const rig_config::Rig& rig, Problems& problems) {
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& device = rig.devices[i];
    if (!device.description || !is_emulated(device)) continue;
    if (const auto why = wire::described::why_silent(*device.description); !why.empty())
      problems.push_back(
          rig_config::problem_at(rig.places, path_of(i, "protocol"),
                                 fmt::format("its emulated device can send nothing: {}", why)));
  }
}

}  // namespace

bool is_emulated(const rig_config::DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri && uri->emulated();
}

Problems check_devices(const rig_config::Rig& rig) {
  Problems problems;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto refuse = [&](const std::string& key, const std::string& why) {
      problems.push_back(rig_config::problem_at(rig.places, path_of(i, key), why));
    };
    const auto made = shell::make_device(rig, i);
    if (!made) {
      refuse(made.error().key, made.error().message);
      continue;
    }
    const auto uri = link::parse_uri(rig.devices[i].link);
    if (!uri->recorded()) continue;
    if (const auto why = why_unplayable(*uri, (*made)->on_bus()); !why.empty()) refuse("link", why);
  }
  check_one_server_each(rig, problems);
  check_one_address_each(rig, problems);
  check_something_is_sent(rig, problems);
  return problems;
}

Problems check_virtual_time(const rig_config::Rig& rig) {
  Problems problems;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& device = rig.devices[i];
    const auto uri = link::parse_uri(device.link);
    if (!uri || uri->emulated() || uri->recorded()) continue;
    problems.push_back(rig_config::problem_at(
        rig.places, path_of(i, "link"),
        fmt::format("device \"{}\": {} is real hardware, which has no virtual time; allowed here: "
                    "pty, memory, memory-can, can:auto, file, socketcan:vcan*",
                    device.name, device.link)));
  }
  return problems;
}

}  // namespace drydock::check
