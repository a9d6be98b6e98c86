#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/water_linked_json_messages.hpp"

namespace drydock::wire {

/// JSON of Water Linked DVLs over TCP: one object a line. There is no checksum. A frame is an
/// object that follows the grammar of JSON, with the line end behind it. An answer of old firmware
/// has none. An object inside a torn line is no frame: the line goes on behind it. A line that
/// breaks the grammar counts as one with a bad checksum. Any version is read by its keys. An object
/// without known keys gives no message.
struct WaterLinkedJson {
  static constexpr std::string_view name = "water-linked-json";
  static constexpr std::size_t max_frame = 4096;  ///< a velocity report has about 1000 bytes
  using Message = std::variant<water_linked_json::Velocity, water_linked_json::WaterVelocity,
                               water_linked_json::Position, water_linked_json::Response,
                               water_linked_json::Command, water_linked_json::Other>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
