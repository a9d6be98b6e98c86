#include "hil/emulate/described/described_frames.hpp"

#include <algorithm>

#include "drivers/wire/described/frame_plan.hpp"

namespace drydock::emulate {
namespace {

constexpr std::uint8_t first_of_own_choice = 128;  // J1939-81: the addresses that a node may choose
constexpr std::uint32_t source_bits = 0xFF;

/// ms in which a message has said all: a multiplexed one sends one selection each cycle time.
unsigned cycle_of(const wire::described::FrameLayout& frame) {
  return frame.message.cycle_ms * static_cast<unsigned>(frame.turns.size());
}

}  // namespace

std::vector<Turn> turns_of(const wire::described::Description& description) {
  const auto& frames = description.frames->frames;
  unsigned shortest_ms = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const unsigned cycle_ms = cycle_of(frames[i]);
    if (description.plan.messages[i].emulated && cycle_ms != 0)
      shortest_ms = shortest_ms == 0 ? cycle_ms : std::min(shortest_ms, cycle_ms);
  }
  std::vector<Turn> turns;
  for (const auto& frame : frames) {
    const unsigned cycle_ms = cycle_of(frame);
    turns.push_back(cycle_ms > shortest_ms ? Turn{cycle_ms, std::max(1u, shortest_ms)} : Turn{});
  }
  return turns;
}

wire::j1939::Name J1939Sender::name(const rig_config::DeviceConfig& config) const {
  wire::j1939::Name name = name_for(config, 0, 0);
  name.arbitrary_address_capable = may_move;
  return name;
}

std::optional<J1939Sender> sender_of(const wire::described::Description& description, int wanted) {
  std::optional<std::uint8_t> fixed;
  bool on_j1939 = false;
  for (const auto& frame : description.frames->frames) {
    if (!frame.is_j1939()) continue;
    on_j1939 = true;
    const auto source = static_cast<std::uint8_t>(frame.message.id & source_bits);
    if (source == wire::dbc::any_source) continue;
    if (fixed && *fixed != source) return {};
    fixed = source;
  }
  if (!on_j1939) return {};
  if (fixed) return J1939Sender{*fixed, false};
  return J1939Sender{wanted != 0 ? static_cast<std::uint8_t>(wanted) : first_of_own_choice, true};
}

}  // namespace drydock::emulate
