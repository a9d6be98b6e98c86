#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

/// The checksums that a description can name.
namespace drydock::wire::described {

/// One row of the CRC catalogue of G. Cook (reveng.sourceforge.io/crc-catalogue). `check` is the
/// CRC of the nine digits "123456789".
struct Crc {
  std::string_view name;
  unsigned width = 0;  ///< bits, up to 32
  std::uint32_t polynomial = 0, start = 0;
  bool reflected = false;  ///< input and output
  std::uint32_t xor_out = 0, check = 0;
};

inline constexpr auto crcs = std::to_array<Crc>({
    {"crc-8/smbus", 8, 0x07, 0x00, false, 0x00, 0xF4},
    {"crc-8/maxim-dow", 8, 0x31, 0x00, true, 0x00, 0xA1},
    {"crc-8/sae-j1850", 8, 0x1D, 0xFF, false, 0xFF, 0x4B},
    {"crc-16/arc", 16, 0x8005, 0x0000, true, 0x0000, 0xBB3D},
    {"crc-16/modbus", 16, 0x8005, 0xFFFF, true, 0x0000, 0x4B37},
    {"crc-16/usb", 16, 0x8005, 0xFFFF, true, 0xFFFF, 0xB4C8},
    {"crc-16/ibm-3740", 16, 0x1021, 0xFFFF, false, 0x0000, 0x29B1},
    {"crc-16/genibus", 16, 0x1021, 0xFFFF, false, 0xFFFF, 0xD64E},
    {"crc-16/xmodem", 16, 0x1021, 0x0000, false, 0x0000, 0x31C3},
    {"crc-16/kermit", 16, 0x1021, 0x0000, true, 0x0000, 0x2189},
    {"crc-16/mcrf4xx", 16, 0x1021, 0xFFFF, true, 0x0000, 0x6F91},
    {"crc-16/ibm-sdlc", 16, 0x1021, 0xFFFF, true, 0xFFFF, 0x906E},
    {"crc-24/lte-a", 24, 0x864CFB, 0x000000, false, 0x000000, 0xCDE703},
    {"crc-32/iso-hdlc", 32, 0x04C11DB7, 0xFFFFFFFF, true, 0xFFFFFFFF, 0xCBF43926},
    {"crc-32/bzip2", 32, 0x04C11DB7, 0xFFFFFFFF, false, 0xFFFFFFFF, 0xFC891918},
    {"crc-32/mpeg-2", 32, 0x04C11DB7, 0xFFFFFFFF, false, 0x00000000, 0x0376E6E7},
    {"crc-32/iscsi", 32, 0x1EDC6F41, 0xFFFFFFFF, true, 0xFFFFFFFF, 0xE3069283},
});

/// Those that are no CRC. `sum-8-negative` makes the sum of all bytes 0; `sum-15` is a sum of 16
/// bits without its highest; of `fletcher-16` (RFC 1145) the sum of the bytes is the low byte.
inline constexpr auto plain_checksums = std::to_array<std::string_view>(
    {"none", "xor", "sum-8", "sum-8-negative", "sum-16", "sum-15", "sum-32", "fletcher-16"});

/// All names, as a description may write them.
std::vector<std::string_view> checksum_names();

/// A checksum of the catalogue or a plain one, ready to run over bytes.
class Checksum {
 public:
  Checksum() = default;  ///< none: it has no bytes

  /// False if no checksum has that name.
  static bool find(std::string_view name, Checksum& into);

  std::uint32_t of(Bytes bytes) const;
  std::size_t size() const { return (width_ + 7) / 8; }  ///< bytes on the wire; 0: there is none
  std::string_view name() const { return name_; }

 private:
  enum class Way : std::uint8_t {
    none,
    exclusive_or,
    sum,
    negative_sum,
    fletcher,
    crc,
    crc_reflected
  };

  Checksum(std::string_view name, Way way, unsigned width)
      : name_(name), way_(way), width_(width) {}
  explicit Checksum(const Crc& crc);

  std::string_view name_{};
  Way way_ = Way::none;
  unsigned width_ = 0;
  std::uint32_t start_ = 0, xor_out_ = 0;
  std::array<std::uint32_t, 256> table_{};
};

}  // namespace drydock::wire::described
