#include "drivers/decode/bus_choice.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <vector>

#include "drivers/link/can/frame_file.hpp"

namespace drydock::decode {
namespace {

std::set<std::string> interfaces_of(const link::Uri& uri) {
  std::set<std::string> names;
  auto file = link::capture_of(uri);
  while (const auto record = file.next()) names.emplace(record->interface);
  return names;
}

}  // namespace

std::string bus_of_device(const link::Uri& uri,
                          const std::function<std::uint64_t(const std::string&)>& count) {
  if (!uri.text_of("interface").empty()) return {};
  const auto names = interfaces_of(uri);
  constexpr std::size_t most_tried = 16;  // each is read as a whole
  if (names.size() > most_tried)
    throw std::runtime_error(fmt::format(
        "{} has {} buses or more: --interface chooses the one of the device (drydock info lists "
        "them)",
        uri.target, names.size()));
  std::vector<std::string> heard;
  if (names.size() > 1)
    for (const auto& name : names)
      if (!name.empty() && count(name) > 0) heard.push_back(name);
  if (heard.size() > 1)
    throw std::runtime_error(fmt::format(
        "{} has measurements of the device on several buses: {}; --interface chooses one",
        uri.target, fmt::join(heard, ", ")));
  return heard.empty() ? std::string() : heard.front();
}

}  // namespace drydock::decode
