#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/shell/raw_listener.hpp"

/// The raw stream of a recording: drydock/RawBytes and drydock/CanFrame of the IDL in plain CDR,
/// little endian. This code is written by hand for speed: most messages of a recording are raw.
namespace drydock::record {

using measurement::Stamp;
using shell::Direction;
using wire::Bytes;

inline constexpr const char* raw_bytes_type = "drydock/msg/RawBytes";
inline constexpr const char* can_frame_type = "drydock/msg/CanFrame";

struct RawBytes {
  Stamp at{};
  Direction direction = Direction::received;
  Bytes data;
};

struct RawFrame {
  Stamp at{};
  Direction direction = Direction::received;
  wire::CanFrame frame;
};

/// Replaces the content of `out`.
void encode(std::vector<std::uint8_t>& out, const RawBytes& raw);
void encode(std::vector<std::uint8_t>& out, const RawFrame& raw);

/// Empty if the bytes are no such message. `data` points into the argument.
std::optional<RawBytes> decode_bytes(Bytes cdr);
std::optional<RawFrame> decode_frame(Bytes cdr);

}  // namespace drydock::record
