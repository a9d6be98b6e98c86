#pragma once

#include <cstdint>
#include <string_view>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::shell {

using measurement::Stamp;

enum class Direction : std::uint8_t { received, sent };

/// Receives every byte and frame below the drivers, in both directions, before any decoding. `link`
/// is the URI as it is in the rig file.
class RawListener {
 public:
  virtual ~RawListener() = default;
  virtual void on_bytes(std::string_view link, Direction direction, wire::Bytes bytes,
                        Stamp at) = 0;
  virtual void on_frame(std::string_view link, Direction direction, const wire::CanFrame& frame,
                        Stamp at) = 0;
};

}  // namespace drydock::shell
