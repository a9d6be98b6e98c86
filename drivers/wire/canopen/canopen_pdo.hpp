#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

/// What a node sends in one PDO (CiA 301: 1800h and 1A00h).
namespace drydock::wire::canopen {

struct Pdo {
  static constexpr std::size_t most_objects = 8;
  static constexpr std::uint32_t off_bit = 1U << 31, id_bits = 0x7FF;

  std::uint32_t cob_id = 0;                           ///< as in 1800h:1
  std::array<std::uint32_t, most_objects> objects{};  ///< index << 16 | subindex << 8 | bits
  std::uint8_t count = 0;                             ///< of the objects

  constexpr Pdo() = default;
  constexpr Pdo(std::uint32_t id, std::initializer_list<std::uint32_t> mapped)
      : cob_id(id), count(static_cast<std::uint8_t>(mapped.size())) {
    std::copy(mapped.begin(), mapped.end(), objects.begin());
  }

  constexpr std::uint32_t id() const { return cob_id & id_bits; }
  constexpr bool is_off() const { return (cob_id & off_bit) != 0; }
  constexpr std::size_t bytes() const {
    std::size_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) bits += objects[i] & 0xFF;
    return bits / 8;
  }
  friend bool operator==(const Pdo&, const Pdo&) = default;
};

}  // namespace drydock::wire::canopen
