#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/wire/described/description.hpp"
#include "hil/emulate/can/j1939_node.hpp"

/// How an emulated sensor on a CAN bus sends the frames of its description.
namespace drydock::emulate {

/// How often a message comes: with the first of so many samples, in the mean.
struct Turn {
  std::uint64_t cycle = 1, shortest = 1;  ///< cycle / shortest samples from one to the next

  double samples() const { return static_cast<double>(cycle) / static_cast<double>(shortest); }

  bool has(std::uint64_t sample) const {
    return sample == 0 || sample * shortest / cycle != (sample - 1) * shortest / cycle;
  }
};

/// Of each message. The message with the shortest cycle time comes with every sample; the others
/// come as much more seldom as the DBC file says. A message without a cycle time comes with every
/// sample.
std::vector<Turn> turns_of(const wire::described::Description& description);

/// The J1939 sender of a description.
struct J1939Sender {
  std::uint8_t address = 0;
  bool may_move = false;  ///< the DBC file says any address

  wire::j1939::Name name(const rig_config::DeviceConfig& config) const;
};

/// Empty: not on J1939, or its messages come from several senders, of which none can claim for all.
/// `wanted`: the address of the rig, 0: none.
std::optional<J1939Sender> sender_of(const wire::described::Description& description, int wanted);

}  // namespace drydock::emulate
