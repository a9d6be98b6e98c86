#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"

/// Expedited SDO transfers of CANopen (CiA 301, 7.2.4): one exchange reads or writes up to 4 bytes
/// of a node's object dictionary. The client asks on 600h + node; the node answers on 580h + node.
/// canopen_segments.hpp has the transfers of longer objects.
namespace drydock::wire::canopen {

constexpr std::uint32_t sdo_request_base = 0x600;
constexpr std::uint32_t sdo_response_base = 0x580;

struct ObjectEntry {
  std::uint16_t index = 0;
  std::uint8_t subindex = 0;
  friend bool operator==(const ObjectEntry&, const ObjectEntry&) = default;
};

/// The client reads an entry (CiA 301: upload).
struct SdoRead {
  std::uint8_t node = 0;
  ObjectEntry entry;
};

/// The client writes an entry (download). `value` holds `size` bytes, 1 to 4, lowest first.
struct SdoWrite {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::uint32_t value = 0;
  std::uint8_t size = 4;
  bool sized = true;  ///< false: as many bytes as the object has
};

/// Answer to a read. The size is also 4 if the node does not give one.
struct SdoValue {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::uint32_t value = 0;
  std::uint8_t size = 4;
};

/// Answer to a write.
struct SdoWritten {
  std::uint8_t node = 0;
  ObjectEntry entry;
};

/// Refusal of a read or write.
struct SdoAbort {
  std::uint8_t node = 0;
  ObjectEntry entry;
  std::uint32_t code = 0;
};

using SdoRequest = std::variant<SdoRead, SdoWrite>;
using SdoResponse = std::variant<SdoValue, SdoWritten, SdoAbort>;

/// Empty for frames of other services and for segmented transfers.
std::optional<SdoRequest> decode_sdo_request(const CanFrame& frame);
std::optional<SdoResponse> decode_sdo_response(const CanFrame& frame);

/// The abort (05040001h, command specifier not valid) with which a node answers any other request:
/// of segments without a transfer, of blocks, or shorter than 8 bytes. Empty for expedited
/// requests, for an abort, which is not answered, and for frames of other services.
std::optional<SdoAbort> refuse_other_request(const CanFrame& frame);

CanFrame encode(const SdoRead& message);
CanFrame encode(const SdoWrite& message);
CanFrame encode(const SdoValue& message);
CanFrame encode(const SdoWritten& message);
CanFrame encode(const SdoAbort& message);

}  // namespace drydock::wire::canopen
