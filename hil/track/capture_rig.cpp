#include "hil/track/capture_rig.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "drivers/shell/rig_devices.hpp"
#include "rig_config/load.hpp"

namespace drydock::track {
namespace {

using rig_config::DeviceConfig;

constexpr auto no_file = "capture.toml";  ///< paths of a made text start in the working folder

std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

rig_config::Rig loaded(boost::system::result<rig_config::Rig, rig_config::Problems> rig) {
  if (!rig) throw std::invalid_argument(to_string(rig.error().front()));
  return std::move(*rig);
}

bool fits(const DeviceConfig& device, const decode::ReplayOptions& capture,
          const std::vector<std::string>& only) {
  return (capture.protocol.empty() || capture.protocol == device.protocol) &&
         (capture.kind.empty() || capture.kind == to_string(device.kind)) &&
         (only.empty() || std::ranges::find(only, device.name) != only.end());
}

std::size_t device_of(const CaptureRig& made, const decode::ReplayOptions& capture,
                      const std::vector<std::string>& only) {
  std::vector<std::size_t> fitting;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < made.rig.devices.size(); ++i) {
    const auto& device = made.rig.devices[i];
    names.push_back(fmt::format("{} ({})", device.name, device.protocol));
    if (fits(device, capture, only)) fitting.push_back(i);
  }
  if (fitting.size() == 1) return fitting.front();
  throw std::invalid_argument(
      fmt::format("{}: {} of its devices may have made the capture; --only "
                  "names it, one of {}",
                  made.file, fitting.empty() ? "none" : "several", fmt::join(names, ", ")));
}

CaptureRig in_rig_file(const decode::ReplayOptions& capture, const std::string& file,
                       const std::vector<std::string>& only) {
  CaptureRig made{loaded(rig_config::load_rig(file)), content_of(file), file, 0, capture};
  made.device = device_of(made, capture, only);
  auto options = shell::device_options(made.rig, made.device);
  if (!options) throw std::invalid_argument(options.error().message);
  made.how.protocol = options->driver.protocol;
  made.how.kind = to_string(options->driver.kind);
  made.how.description = options->driver.description;
  if (made.how.baud == 0) made.how.baud = options->driver.baud.value_or(0);
  if (made.how.address == 0) made.how.address = options->driver.address;
  made.how.driver = std::move(options->driver);
  return made;
}

}  // namespace

CaptureRig rig_of_capture(const decode::ReplayOptions& capture, const std::string& rig_file,
                          const std::vector<std::string>& only) {
  if (!rig_file.empty()) return in_rig_file(capture, rig_file, only);
  if (capture.protocol.empty())
    throw std::invalid_argument(capture.capture +
                                " is no MCAP recording: --protocol says what its sensor speaks, or "
                                "--rig names a rig file with the sensor");
  DeviceConfig device;
  device.kind = decode::kind_of(capture);
  device.name = std::string(to_string(device.kind));
  device.protocol = capture.protocol;
  device.address = capture.address;
  if (!only.empty() && only != std::vector{device.name})
    throw std::invalid_argument(fmt::format("--only {}: a capture has one sensor, \"{}\"",
                                            fmt::join(only, ","), device.name));
  const auto text = capture_rig_text(device, capture.baud);
  return {loaded(rig_config::load_rig_text(text, no_file)), text, {}, 0, capture};
}

bool may_be_of_several(const decode::ReplayOptions& capture, const std::string& rig_file,
                       const std::vector<std::string>& only) {
  if (rig_file.empty()) return false;
  const auto rig = loaded(rig_config::load_rig(rig_file));
  return std::ranges::count_if(rig.devices, [&](const DeviceConfig& device) {
           return fits(device, capture, only);
         }) > 1;
}

std::string capture_rig_text(const DeviceConfig& device, unsigned baud) {
  const auto link = baud > 0 ? fmt::format("file:capture?baud={}", baud) : "file:capture";
  return fmt::format(
      "[rig]\nname = \"capture\"\n\n[[device]]\nname = \"{}\"\nkind = \"{}\"\nprotocol = \"{}\"\n"
      "link = \"{}\"\n{}",
      device.name, to_string(device.kind), device.protocol, link,
      device.address > 0 ? fmt::format("address = {}\n", device.address) : "");
}

}  // namespace drydock::track
