#include "drivers/decode/replayed_device.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "drivers/decode/decode.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::decode {
namespace {

using device::Device;
using device::Kind;

/// The kinds of sensor that speak the protocol.
std::vector<Kind> kinds_with(const ReplayOptions& options) {
  std::vector<Kind> kinds;
  const wire::Protocol* known =
      options.description ? &options.description->facts : wire::find_protocol(options.protocol);
  for (const Kind kind : measurement::kinds)
    if (known && known->kinds.has(kind)) kinds.push_back(kind);
  return kinds;
}

}  // namespace

Kind kind_of(const ReplayOptions& options) {
  const auto kinds = kinds_with(options);
  std::string names;
  for (const Kind kind : kinds) {
    if (to_string(kind) == options.kind || (options.kind.empty() && kinds.size() == 1)) return kind;
    names.append(names.empty() ? "" : ", ").append(to_string(kind));
  }
  throw std::invalid_argument(kinds.empty()
                                  ? fmt::format("no driver speaks \"{}\"; allowed: {}",
                                                options.protocol, decode_protocols())
                                  : fmt::format("--kind says which sensor speaks {}; allowed: {}",
                                                options.protocol, names));
}

link::Uri uri_of(const ReplayOptions& options) {
  std::string text = link::file_uri(options.capture) + "?speed=" + options.speed;
  if (options.baud > 0) text += fmt::format("&baud={}", options.baud);
  if (options.bitrate > 0) text += fmt::format("&bitrate={}", options.bitrate);
  if (options.data_bitrate > 0) text += fmt::format("&data_bitrate={}", options.data_bitrate);
  if (!options.format.empty()) text += "&format=" + options.format;
  if (!options.clock.empty()) text += "&clock=" + options.clock;
  if (!options.interface.empty()) text += "&interface=" + options.interface;
  return link::parse_uri(text).value();
}

std::unique_ptr<Device> replayed_device(const ReplayOptions& options, const link::Uri& uri) {
  device::DeviceOptions wanted;
  if (options.driver) wanted.driver = *options.driver;
  wanted.driver.kind = kind_of(options);
  wanted.driver.protocol = options.protocol;
  wanted.driver.description = options.description;
  wanted.driver.baud = uri.baud();
  wanted.driver.byte_frame = uri.byte_frame();
  if (options.bitrate > 0) wanted.driver.bitrate = options.bitrate;
  if (options.data_bitrate > 0) wanted.driver.data_bitrate = options.data_bitrate;
  wanted.driver.address = options.address;
  wanted.name = to_string(wanted.driver.kind);
  wanted.link = uri.text;
  wanted.life_cycle.reopen_when_quiet = false;  // opening it again would restart the capture
  wanted.life_cycle.quiet_but_up = " in the recording";
  auto made = Device::make(std::move(wanted));
  if (!made) throw std::invalid_argument(made.error().message);
  const auto carries = (*made)->on_bus() ? link::Carries::frames : link::Carries::bytes;
  const std::string misfit = link::recording_misfit(uri, carries);
  if (!misfit.empty()) throw std::invalid_argument(misfit);
  return std::move(*made);
}

}  // namespace drydock::decode
