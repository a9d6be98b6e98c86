#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/water_linked_messages.hpp"

namespace drydock::wire {

/// Serial protocol of Water Linked DVLs, versions 2.1 to 2.7. A line is `w`, `c` (to the DVL) or
/// `r` (from it), a letter, options, `*`, and a CRC-8 (polynomial 07h) of everything before it in
/// two hex digits. It ends with LF, CR LF or CR. Only a command may omit the checksum.
struct WaterLinked {
  static constexpr std::string_view name = "water-linked";
  static constexpr std::size_t max_frame = 512;
  using Message =
      std::variant<water_linked::BottomVelocity, water_linked::WaterVelocity,
                   water_linked::OldVelocity, water_linked::Transducer, water_linked::OldRanges,
                   water_linked::DeadReckoning, water_linked::Version, water_linked::Product,
                   water_linked::Configuration, water_linked::Answer, water_linked::Command>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

namespace water_linked {

/// CRC-8, polynomial 07h, initial value 0, not reflected.
std::uint8_t crc8(std::string_view text);

}  // namespace water_linked
}  // namespace drydock::wire
