#include "drivers/wire/protocols.hpp"

#include <algorithm>
#include <tuple>

#include "drivers/wire/registry.hpp"

namespace drydock::wire {

namespace {

constexpr auto table =
    std::apply([](const auto&... row) { return std::array{row.facts...}; },
               std::tuple_cat(byte_protocols, frame_protocols, frames_as_they_are, frame_carriers));

}  // namespace

std::span<const Protocol> protocols() { return table; }

const Protocol* find_protocol(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Protocol::name);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace drydock::wire
