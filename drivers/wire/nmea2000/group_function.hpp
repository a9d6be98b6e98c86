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
                                read_reply = 4, write_fields = 5, write_reply = 6;
  static constexpr std::uint32_t interval_unchanged = 0xFFFFFFFF, interval_default = 0xFFFFFFFE;
  static constexpr std::uint16_t offset_unchanged = 0xFFFF;
  static constexpr std::uint8_t priority_unchanged = 8, priority_default = 9;

  std::uint8_t function = request;
  std::uint32_t subject = 0;                       ///< the PGN that it is about
  std::uint32_t interval_ms = interval_unchanged;  ///< of a request; 0: never
  std::uint16_t offset_10ms = offset_unchanged;    ///< of a request, from when it comes
  std::uint8_t priority = priority_unchanged;      ///< of a command
  std::uint8_t parameters = 0;                     ///< pairs of field and value
  Bytes pairs;                                     ///< as long as the message is
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
    got.offset_10ms = load_le<std::uint16_t>(data, 8);
    got.parameters = data[10];
    got.pairs = data.subspan(11);
  } else if (got.function == GroupFunction::command) {
    if (data.size() < 6) return std::nullopt;
    got.priority = data[4] & 0xF;
    got.parameters = data[5];
    got.pairs = data.subspan(6);
  }
  return got;
}

/// The answer to a group function. Each code is four bits; 0 is "done".
struct GroupAcknowledgement {
  static constexpr std::uint8_t pgn_unknown = 1, pgn_not_supported = 4, no_read_or_write = 6;
  static constexpr std::uint8_t interval_not_supported = 1, interval_too_low = 2;
  static constexpr std::uint8_t parameter_invalid = 1, parameter_not_now = 2,
                                parameter_out_of_range = 3, parameter_access_denied = 4,
                                parameter_not_supported = 5;

  std::uint32_t subject = 0;
  std::uint8_t pgn_code = 0, interval_code = 0;
  std::uint8_t parameters = 0;
  std::array<std::uint8_t, 256> parameter_codes{};  ///< as many as there are parameters
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
  const std::size_t bytes = (answer.parameters + 1u) / 2u;
  for (std::size_t i = 0; i < bytes; ++i) {
    const bool alone = 2 * i + 1 == answer.parameters;
    const unsigned second = alone ? 0xFu : answer.parameter_codes[2 * i + 1];
    buffer[6 + i] = static_cast<std::uint8_t>(second << 4 | answer.parameter_codes[2 * i]);
  }
  return buffer.first(6 + bytes);
}

}  // namespace drydock::wire::nmea2000
