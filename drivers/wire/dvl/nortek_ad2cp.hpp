#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/ad2cp_messages.hpp"

namespace drydock::wire {

/// Records of Nortek's AD2CP instruments: DVLs and Signatures. Text between the records (the banner
/// of a data port, replies to commands) is skipped.
struct NortekAd2cp {
  static constexpr std::string_view name = "nortek-ad2cp";
  /// A longer record is skipped: raw echoes and profiles of hundreds of cells, no bottom track.
  static constexpr std::size_t max_frame = 16384;
  using Message = std::variant<ad2cp::BottomTrack, ad2cp::WaterTrack, ad2cp::SignatureBottomTrack,
                               ad2cp::Other>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

namespace ad2cp {

inline constexpr std::size_t track_record_size = 222, signature_record_size = 120;

/// Write a record as a DVL sends it: what is empty gets the mark of a missing value, and the low 20
/// bits of the status say so. Return its bytes, 0 if `out` is too small.
std::size_t encode(const BottomTrack& m, std::span<std::uint8_t> out);
std::size_t encode(const WaterTrack& m, std::span<std::uint8_t> out);
/// Four beams, without figures of merit.
std::size_t encode(const SignatureBottomTrack& m, std::span<std::uint8_t> out);

}  // namespace ad2cp
}  // namespace drydock::wire
