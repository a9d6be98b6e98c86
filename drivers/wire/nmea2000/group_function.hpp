#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/codec.hpp"

/// The NMEA group function (PGN 126208), by which one node asks or commands another. Layouts and
/// codes: canboat's database of PGNs.
namespace drydock::wire::nmea2000 {

struct GroupFunction {
  static constexpr std::uint32_t pgn = 126208;
  static constexpr std::uint8_t request = 0, command = 1, acknowledge = 2, read_fields = 3,
                                write_fields = 5;
  static constexpr std::uint32_t interval_unchanged = 0xFFFFFFFF, interval_default = 0xFFFFFFFE;
  static constexpr std::uint8_t priority_unchanged = 8;

  std::uint8_t function = request;
  std::uint32_t subject = 0;                       ///< the PGN that it is about
  std::uint32_t interval_ms = interval_unchanged;  ///< of a request
  std::uint8_t priority = priority_unchanged;      ///< of a command
  std::uint8_t parameters = 0;                     ///< pairs of field and value
};

/// Empty for one that is shorter than its fixed part.
constexpr std::optional<GroupFunction> decode_group_function(Bytes data) {
  if (data.size() < 4) return std::nullopt;
  GroupFunction got;
  got.function = data[0];
  got.subject = data[1] | std::uint32_t{data[2]} << 8 | std::uint32_t{data[3]} << 16;
  if (got.function == GroupFunction::request) {
    if (data.size() < 11) return std::nullopt;
    got.interval_ms = load_le<std::uint32_t>(data, 4);
    got.parameters = data[10];
  } else if (got.function == GroupFunction::command) {
    if (data.size() < 6) return std::nullopt;
    got.priority = data[4] & 0xF;
    got.parameters = data[5];
  }
  return got;
}

/// The answer to a group function. Each code is four bits; 0 is "done".
struct GroupAcknowledgement {
  static constexpr std::uint8_t pgn_unknown = 1, pgn_not_supported = 4, no_read_or_write = 6;
  static constexpr std::uint8_t interval_not_supported = 1, interval_too_low = 2;
  static constexpr std::uint8_t parameter_invalid = 1, parameter_not_supported = 5;

  std::uint32_t subject = 0;
  std::uint8_t pgn_code = 0, interval_code = 0;
  std::uint8_t parameters = 0, parameter_code = 0;  ///< all parameters have the same code
};

constexpr std::size_t group_acknowledgement_max_bytes = 6 + 128;

/// Returns the part of `buffer` that holds the message.
constexpr std::span<const std::uint8_t> encode_group_acknowledgement(
    const GroupAcknowledgement& answer,
    std::span<std::uint8_t, group_acknowledgement_max_bytes> buffer) {
  buffer[0] = GroupFunction::acknowledge;
  for (unsigned i = 0; i < 3; ++i)
    buffer[1 + i] = static_cast<std::uint8_t>(answer.subject >> 8 * i);
  buffer[4] = static_cast<std::uint8_t>(answer.interval_code << 4 | answer.pgn_code);
  buffer[5] = answer.parameters;
  const std::size_t pairs = answer.parameters / 2u, odd = answer.parameters % 2u;
  for (std::size_t i = 0; i < pairs; ++i)
    buffer[6 + i] = static_cast<std::uint8_t>(answer.parameter_code << 4 | answer.parameter_code);
  if (odd != 0) buffer[6 + pairs] = static_cast<std::uint8_t>(0xF0 | answer.parameter_code);
  return buffer.first(6 + pairs + odd);
}

}  // namespace drydock::wire::nmea2000
