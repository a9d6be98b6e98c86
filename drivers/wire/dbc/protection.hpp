#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Checksums and counters that frames carry above CAN. A DBC file names such a signal but cannot
/// say how it is computed.
namespace drydock::wire::dbc {

/// AUTOSAR E2E profiles 1, 2 and 5, with the ways in which profile 1 includes its data identifier;
/// SAE J1850; a sum or an XOR of bytes.
enum class Checksum : std::uint8_t {
  e2e_1_both,
  e2e_1_alternating,
  e2e_1_low,
  e2e_1_nibble,
  e2e_2,
  e2e_5,
  crc8_j1850,       ///< start FFh, XOR FFh
  crc8_j1850_bare,  ///< start 0, XOR with `seed`
  sum,              ///< of the other bytes and `seed`
  sum_with_id,      ///< also of the length and of the bytes of the identifier
  xor_of_bytes,     ///< of the other bytes and `seed`
};

/// AUTOSAR's profile 1 counts from 0 to 14; 15 means that the frame is not valid.
constexpr unsigned modulus_of_profile_1 = 15;
constexpr bool is_profile_1(Checksum checksum) { return checksum <= Checksum::e2e_1_nibble; }

/// Names of rig files: "e2e-1-both" and so on.
std::optional<Checksum> checksum_named(std::string_view name);
std::string_view to_string(Checksum checksum);

struct Protection {
  Checksum checksum = Checksum::crc8_j1850;
  std::size_t at = 0;                       ///< byte of the checksum; E2E fixes it at 0
  std::uint16_t data_id = 0;                ///< profiles 1 and 5
  std::array<std::uint8_t, 16> data_ids{};  ///< profile 2: one to each counter
  std::uint8_t seed = 0;
};

/// True if the frame's checksum is right. A frame too short for it is wrong, and so is a counter
/// that profile 1 does not have.
bool is_intact(const Protection& protection, const CanFrame& frame);

/// Writes the checksum, over the counter and data that stand in the frame. False if it is too
/// short.
bool protect(const Protection& protection, CanFrame& frame);

/// Follows a counter of frames. It counts up by one and wraps at its modulus.
class FrameCounter {
 public:
  enum class Step : std::uint8_t { first, next, repeated, lost };

  explicit FrameCounter(unsigned modulus) : modulus_(modulus) {}

  Step take(unsigned counter);
  std::uint64_t lost() const { return lost_; }          ///< frames that never came
  std::uint64_t repeated() const { return repeated_; }  ///< stale frames
  void reset() { last_.reset(); }

 private:
  unsigned modulus_;
  std::optional<unsigned> last_;
  std::uint64_t lost_ = 0, repeated_ = 0;
};

}  // namespace drydock::wire::dbc
