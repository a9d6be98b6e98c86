#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "drivers/wire/canopen/canopen_sdo.hpp"

/// Segmented SDO transfers of CANopen (CiA 301, 7.2.4.3) as a node sees them: an object of any
/// length goes in segments of 7 bytes, whose toggle bit begins with 0 and alternates.
namespace drydock::wire::canopen {

/// The client asks for the next segment of what it reads.
struct SdoNextSegment {
  std::uint8_t node = 0;
  bool toggle = false;
};

/// One segment, in either direction.
struct SdoSegment {
  static constexpr std::size_t most_bytes = 7;
  std::uint8_t node = 0;
  bool toggle = false, last = false;
  std::array<std::uint8_t, most_bytes> data{};
  std::uint8_t size = 0;
};

/// The client will write an entry in segments.
struct SdoLongWrite {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::optional<std::uint32_t> size;  ///< of all bytes, if the client says it
};

/// The client reads an entry in blocks. An object of up to `threshold` bytes may be answered as
/// SdoRead; 0: none may.
struct SdoBlockRead {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::uint8_t threshold = 0;
};

/// The client ends the transfer.
struct SdoGivenUp {
  std::uint8_t node = 0;
};

using SdoLongRequest =
    std::variant<SdoNextSegment, SdoSegment, SdoLongWrite, SdoBlockRead, SdoGivenUp>;

/// Empty for expedited transfers and frames of other services.
std::optional<SdoLongRequest> decode_sdo_long_request(const CanFrame& frame);

/// Answer to a read whose bytes come in segments.
struct SdoLongValue {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::uint32_t size = 0;
};

/// Answer to a segment of a write.
struct SdoSegmentTaken {
  std::uint8_t node = 0;
  bool toggle = false;
};

CanFrame encode(const SdoLongValue& message);
CanFrame encode(const SdoSegment& message);  ///< from the node
CanFrame encode(const SdoSegmentTaken& message);

}  // namespace drydock::wire::canopen
