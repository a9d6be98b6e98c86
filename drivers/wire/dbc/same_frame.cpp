#include "drivers/wire/dbc/same_frame.hpp"

#include <array>
#include <map>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::wire::dbc {
namespace {

/// What finds a message: its identifier, and for J1939 what of it names the group.
std::array<std::uint64_t, 2> keys_of(const Message& message) {
  constexpr std::uint64_t extended = std::uint64_t{1} << 32, group = std::uint64_t{1} << 33;
  const std::uint64_t exact = message.id | (message.extended ? extended : 0);
  if (message.format != FrameFormat::j1939) return {exact, exact};
  auto id = j1939::parse_identifier(message.id);
  id.priority = 0;
  if (id.source == any_source) id.destination = j1939::global_address;
  return {exact, group | j1939::make_identifier(id)};
}

}  // namespace

std::vector<SameFrame> same_frames(std::span<const Message> messages) {
  std::map<std::uint64_t, std::size_t> known;
  std::vector<SameFrame> found;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    std::optional<std::size_t> before;
    for (const std::uint64_t key : keys_of(messages[i]))
      if (const auto [at, is_new] = known.emplace(key, i); !is_new && at->second != i)
        before = at->second;
    if (before) found.push_back({*before, i});
  }
  return found;
}

}  // namespace drydock::wire::dbc
