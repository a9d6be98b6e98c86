#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// A text of 16 bits a letter, with the mark of its byte order in front, as some Windows programs
/// write it, as UTF-8 (RFC 3629, RFC 2781). Half a pair becomes U+FFFD. Feed the blocks in order.
class Utf16Text {
 public:
  /// The mark, and letters of ASCII behind it: FF FE alone may be bytes of a sensor.
  static bool recognises(wire::Bytes head);

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);

 private:
  void take(std::uint32_t unit);
  void put(std::uint32_t letter);

  bool begun_ = false, big_endian_ = false;
  std::optional<std::uint8_t> half_;   ///< of a letter
  std::optional<std::uint32_t> high_;  ///< half of a pair
  std::vector<std::uint8_t> text_;
};

}  // namespace drydock::capture
