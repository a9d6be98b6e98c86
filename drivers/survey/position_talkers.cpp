#include "drivers/survey/position_talkers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "drivers/device/gnss/position_talker.hpp"

namespace drydock::survey {

std::string note_of_receivers(const ByteFinding& finding) {
  constexpr std::size_t name_size = 6;  // $GPRMC
  constexpr std::array<std::string_view, 4> positions{"GGA", "RMC", "GNS", "GLL"};
  std::vector<wire::Talker> receivers;
  std::vector<std::string> talkers;
  for (const auto& [name, count] : finding.read) {
    if (name.size() != name_size || std::ranges::find(positions, name.substr(3)) == positions.end())
      continue;
    const wire::Talker talker(std::string_view(name).substr(1, 2));
    const auto receiver = device::PositionTalker::receiver_of(talker);
    if (std::ranges::find(receivers, receiver) != receivers.end()) continue;
    const bool first = receiver == device::PositionTalker::satellites;
    receivers.insert(first ? receivers.begin() : receivers.end(), receiver);
    talkers.insert(first ? talkers.begin() : talkers.end(), std::string(talker.text()));
  }
  if (talkers.size() < 2) return {};
  return fmt::format(
      "{} receivers tell positions on this line, with the talkers {}: the gnss driver takes {}, "
      "and another one when that is silent",
      talkers.size(), fmt::join(talkers, ", "), talkers.front());
}

}  // namespace drydock::survey
