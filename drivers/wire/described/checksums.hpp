#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/described/crc_catalogue.hpp"

/// The checksums that a description can name.
namespace drydock::wire::described {

/// Those that are no CRC. A `-negative` one makes the sum of all 0, an `-inverted` one has all bits
/// of the sum turned; `sum-15` is a sum of 16 bits without its highest; of `fletcher-16`
/// (RFC 1145) the sum of the bytes is the low byte, and of `fletcher-16-255` the sums are taken
/// modulo 255. The word sums add 16-bit words, `-big` with the high byte first; an odd last byte is
/// a word with a zero behind it.
inline constexpr auto plain_checksums = std::to_array<std::string_view>({"none",
                                                                         "xor",
                                                                         "sum-8",
                                                                         "sum-8-negative",
                                                                         "sum-8-inverted",
                                                                         "sum-16",
                                                                         "sum-16-negative",
                                                                         "sum-16-inverted",
                                                                         "sum-15",
                                                                         "sum-32",
                                                                         "sum-32-negative",
                                                                         "sum-32-inverted",
                                                                         "word-sum-16",
                                                                         "word-sum-16-negative",
                                                                         "word-sum-16-inverted",
                                                                         "word-sum-16-big",
                                                                         "word-sum-16-big-negative",
                                                                         "word-sum-16-big-inverted",
                                                                         "fletcher-16",
                                                                         "fletcher-16-255"});

/// All names, as a description may write them.
std::vector<std::string_view> checksum_names();

/// A checksum of the catalogue or a plain one, ready to run over bytes.
class Checksum {
 public:
  Checksum() = default;  ///< none: it has no bytes
  explicit Checksum(const Crc& crc);

  /// False if no checksum has that name, in capitals or not. Other names of the catalogue count.
  static bool find(std::string_view name, Checksum& into);

  /// `extra`: bytes that a CRC takes in behind the others, and that are not sent.
  std::uint32_t of(Bytes bytes, Bytes extra = {}) const;
  /// Of three at once, in half the time: a CRC waits for its table, and three of them wait
  /// together.
  std::array<std::uint32_t, 3> of_three(const std::array<Bytes, 3>& each) const;
  bool is_crc() const { return way_ == Way::crc || way_ == Way::crc_reflected; }
  /// Of a CRC: that with its polynomial whose start value and last XOR are 0. The XOR of two
  /// messages of one length has the XOR of their two sums by it.
  Checksum linear() const;
  /// Of a CRC: one number for all that have the same `linear()`.
  std::uint64_t polynomial() const;
  std::size_t size() const { return (width_ + 7) / 8; }  ///< bytes on the wire; 0: there is none
  std::string_view name() const { return name_; }

 private:
  enum class Way : std::uint8_t {
    none,
    exclusive_or,
    sum,
    word_sum,
    big_word_sum,
    fletcher,
    fletcher_255,
    crc,
    crc_reflected
  };

  enum class Finish : std::uint8_t { as_it_is, negative, inverted };

  Checksum(std::string_view name, Way way, unsigned width) : name_(name), way_(way), width_(width) {
    if (name.ends_with("-negative")) finish_ = Finish::negative;
    if (name.ends_with("-inverted")) finish_ = Finish::inverted;
  }

  std::uint32_t finished(std::uint32_t sum) const;
  /// `crc` behind one byte more; `way` is `way_`, known to the compiler so that no loop asks for
  /// it.
  template <Way way>
  std::uint32_t after(std::uint32_t crc, std::uint8_t byte) const {
    if constexpr (way == Way::crc) return crc << 8 ^ table_[crc >> 24 ^ byte];
    return crc >> 8 ^ table_[(crc ^ byte) & 0xFF];
  }
  template <Way way>
  std::uint32_t crc_of(Bytes bytes, Bytes extra) const;
  template <Way way>
  std::array<std::uint32_t, 3> crcs_of(const std::array<Bytes, 3>& each) const;
  std::uint32_t out_of(std::uint32_t crc) const {
    return (way_ == Way::crc ? crc >> (32 - width_) : crc) ^ xor_out_;
  }

  std::string_view name_{};
  Way way_ = Way::none;
  Finish finish_ = Finish::as_it_is;
  unsigned width_ = 0;
  std::uint32_t start_ = 0, xor_out_ = 0;
  std::array<std::uint32_t, 256> table_{};
};

}  // namespace drydock::wire::described
