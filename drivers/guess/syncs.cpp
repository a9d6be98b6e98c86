#include "drivers/guess/syncs.hpp"

namespace drydock::guess {

std::vector<Sync> syncs_of(wire::Bytes capture) {
  std::vector<Sync> pairs(0x10000), singles(0x100);
  for (std::size_t i = 0; i + 1 < capture.size(); ++i) {
    const auto place = static_cast<std::uint32_t>(i);
    pairs[capture[i] << 8 | capture[i + 1]].places.push_back(place);
    singles[capture[i]].places.push_back(place);
  }
  std::vector<Sync> all;
  for (std::size_t i = 0; i < pairs.size() + singles.size(); ++i) {
    const bool pair = i < pairs.size();
    Sync& one = pair ? pairs[i] : singles[i - pairs.size()];
    if (one.places.size() < fewest_synced_frames ||
        one.places.size() * shortest_synced_frame > capture.size())
      continue;
    one.size = pair ? 2 : 1;
    one.bytes = pair ? std::array{static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)}
                     : std::array{static_cast<std::uint8_t>(i - pairs.size()), std::uint8_t{0}};
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace drydock::guess
