#include "hil/endurance/emulated_rig.hpp"

#include <fmt/format.h>

#include <map>

#include "drivers/link/uri.hpp"

namespace drydock::endurance {
namespace {

std::string emulated_link(const link::Uri& real, std::size_t number) {
  if (real.carries() == link::Carries::frames) {
    const auto rate = real.bitrate();
    return fmt::format("memory-can:line{}{}", number,
                       rate ? fmt::format("?bitrate={}", *rate) : "");
  }
  const auto rate = real.baud();
  return fmt::format("memory:line{}{}", number, rate ? fmt::format("?baud={}", *rate) : "");
}

}  // namespace

rig_config::Rig all_emulated(rig_config::Rig rig) {
  std::map<std::string, std::string> in_place_of;
  for (auto& device : rig.devices) {
    const auto uri = link::parse_uri(device.link);
    if (!uri || uri->emulated() || uri->recorded()) continue;
    const auto [entry, is_new] = in_place_of.try_emplace(device.link);
    if (is_new) entry->second = emulated_link(*uri, in_place_of.size());
    device.link = entry->second;
  }
  return rig;
}

}  // namespace drydock::endurance
