#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/pd0_ensemble.hpp"

namespace drydock::wire {

/// Teledyne RDI PD0 ensembles: 7F 7F, length, table of offsets, data types in any order, sum of all
/// bytes modulo 65536. It skips data types that are not decoded here.
struct Pd0 {
  static constexpr std::string_view name = "pd0";
  /// A greater length means a false sync. 255 cells of four beams and four profiles need 8.3 kB.
  static constexpr std::size_t max_frame = 16384;
  using Message = std::variant<Pd0Ensemble>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
  /// Tells the id of each data type of a frame that is not decoded.
  static void unread_blocks(Bytes frame, const std::function<void(std::uint16_t)>& tell);
};

}  // namespace drydock::wire
