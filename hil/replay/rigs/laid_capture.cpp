#include "hil/replay/rigs/laid_capture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "drivers/link/uri.hpp"
#include "hil/replay/rigs/joined_series.hpp"
#include "hil/replay/rigs/part_choice.hpp"
#include "hil/replay/rigs/unread_sensors.hpp"

namespace drydock::replay {
namespace {

using Names = std::vector<std::string>;

std::vector<CapturePart> all_parts(const RigCaptures& captures) {
  std::vector<CapturePart> all;
  Names read;
  for (const auto& file : captures.files) {
    if (std::ranges::find(read, file.path) != read.end()) continue;
    read.push_back(file.path);
    auto parts = parts_of(file.path, file.format.empty() ? captures.how.format : file.format);
    for (auto& part : parts) {
      part.shown = file.shown;
      all.push_back(std::move(part));
    }
  }
  return all;
}

/// The rates of the capture's line or bus are those of the options, else of the device's own link.
std::string link_of(const decode::ReplayOptions& how, const CapturePart& part,
                    const std::string& own_link) {
  const auto own = link::parse_uri(own_link).value();
  std::string text = link::file_uri(part.file);
  char before = '?';
  const auto add = [&](std::string_view key, std::string_view value) {
    if (value.empty() || value == "0" || value == "auto") return;
    text += fmt::format("{}{}={}", std::exchange(before, '&'), key, value);
  };
  const auto rate = [&](std::string_view key, unsigned wanted) {
    add(key, wanted > 0 ? fmt::format("{}", wanted) : std::string(own.text_of(key)));
  };
  add("format", part.format);
  add("clock", how.clock);
  add("interface", part.name);
  if (part.frames) {
    rate("bitrate", how.bitrate);
    rate("data_bitrate", how.data_bitrate);
  } else {
    rate("baud", how.baud);
    for (const char* key : {"bits", "parity", "stop"}) add(key, own.text_of(key));
  }
  return text;
}

}  // namespace

OtherRig lay(rig_config::Rig rig, const RigCaptures& named) {
  auto series = join_series(rig, named);
  const auto& captures = series.captures;
  const auto parts = all_parts(captures);
  const auto part_of = parts_of_devices(rig, captures, parts);
  OtherRig laid{std::move(rig), std::move(series.notes), std::move(series.files)};
  std::vector<std::string> links(parts.size());  // devices of one part share its link
  std::vector<std::vector<rig_config::DeviceConfig>> readers(parts.size());
  Names silent;
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    auto& device = laid.rig.devices[i];
    if (!part_of[i]) {
      silent.push_back(device.name);
      continue;
    }
    const std::size_t part = *part_of[i];
    if (links[part].empty()) links[part] = link_of(captures.how, parts[part], device.link);
    device.link = links[part];
    readers[part].push_back(device);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Names names;
    for (const auto& device : readers[i]) names.push_back(device.name);
    laid.notes.push_back(
        names.empty() ? in_words(parts[i]) + ": no device of this rig reads it"
                      : fmt::format("{}: read by {}", in_words(parts[i]), fmt::join(names, ", ")));
    std::ranges::move(unread_sensors(parts[i], captures.how, readers[i]),
                      std::back_inserter(laid.notes));
  }
  for (const auto& name : silent)
    laid.notes.push_back(name + ": left out, no capture has measurements of it");
  leave_out(silent, laid);
  if (laid.rig.devices.empty())
    throw std::runtime_error(fmt::format("no device of {} makes a measurement of this: {}",
                                         laid.rig.file, fmt::join(laid.notes, "; ")));
  return laid;
}

}  // namespace drydock::replay
