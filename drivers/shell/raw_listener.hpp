#pragma once

#include <cstdint>
#include <string_view>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::shell {

using measurement::Stamp;

enum class Direction : std::uint8_t { received, sent };

/// Sees every byte and frame below the drivers, both directions, before anything is understood.
/// `link` is the URI as the rig file has it.
class RawListener {
 public:
  virtual ~RawListener() = default;
  virtual void on_bytes(std::string_view link, Direction direction, wire::Bytes bytes,
                        Stamp at) = 0;
  virtual void on_frame(std::string_view link, Direction direction, const wire::CanFrame& frame,
                        Stamp at) = 0;
};

}  // namespace drydock::shell
