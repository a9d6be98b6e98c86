#pragma once

#include <optional>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/message_list.hpp"
#include "drivers/wire/ubx_nav.hpp"

namespace drydock::wire {

using UbxMessages = MessageList<NavPvt, NavSat, NavEoe>;

/// u-blox binary: B5 62, class, id, length (u16), payload, Fletcher-8 over class to payload.
struct Ubx {
  static constexpr std::string_view name = "ubx";
  /// Holds a NAV-SAT of 255 satellites. A longer claim is a damaged length and must not make the
  /// stream wait for bytes that never come.
  static constexpr std::size_t max_frame = 4096 + 8;
  using Message = UbxMessages::Variant;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
