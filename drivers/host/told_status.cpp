#include "drivers/host/told_status.hpp"

#include <string_view>

namespace drydock::host {
namespace {

constexpr std::string_view suffix = "/told";

}  // namespace

bus::DeviceStatus status_of(const Told& told) {
  return {.level = bus::Level::ok,
          .name = told.device + std::string(suffix),
          .message = told.what,
          .hardware_id = told.device,
          .values = {}};
}

std::optional<Told> told_of(const bus::DeviceStatus& status) {
  const std::string_view name = status.name;
  if (!name.ends_with(suffix)) return {};
  return Told{std::string(name.substr(0, name.size() - suffix.size())), status.message};
}

}  // namespace drydock::host
