#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "drivers/wire/canopen/canopen_sdo.hpp"

namespace drydock::emulate {

/// The contents of a PDO in the form of 1A00h: index << 16 | subindex << 8 | bits.
using PdoMapping = std::span<const std::uint32_t>;

/// How one PDO is set up.
struct CanopenPdo {
  static constexpr std::size_t most_objects = 8;
  static constexpr std::uint8_t on_each_sync = 1, last_synchronous = 240, by_the_profile = 0xFE;
  static constexpr std::uint32_t invalid_bit = 1U << 31, extended_bit = 1U << 29, id_bits = 0x7FF;

  std::uint32_t cob_id = invalid_bit;
  std::uint8_t type = by_the_profile;
  std::uint16_t inhibit = 0;   ///< shortest time between two, 100 us
  std::uint16_t timer_ms = 0;  ///< longest time between two; 0: at each sample
  std::uint8_t objects = 0;
  std::array<std::uint32_t, most_objects> mapping{};

  std::uint32_t id() const { return cob_id & id_bits; }
  bool is_valid() const { return (cob_id & invalid_bit) == 0; }
  bool is_on() const { return is_valid() && objects != 0; }
  bool is_synchronous() const { return type >= on_each_sync && type <= last_synchronous; }
  std::chrono::microseconds inhibit_time() const {
    return std::chrono::microseconds{100} * inhibit;
  }
  std::size_t bits() const;
};

/// The PDOs of one direction (CiA 301: 1800h and 1A00h on, or 1400h and 1600h on). A master
/// switches each off and on by bit 31 of its COB-ID, and sets it up while it is off: identifier,
/// transmission type, times, mapping.
class CanopenPdos {
 public:
  static constexpr std::size_t most = 4;
  using Setup = std::array<CanopenPdo, most>;

  enum class Direction : std::uint8_t { sent, taken };
  struct Kind {
    Direction direction = Direction::sent;
    std::uint8_t node = 1;
    std::span<const PdoMapping> delivered;    ///< each PDO that there is
    std::span<const std::uint32_t> mappable;  ///< what a master may map, in the form of a mapping
    std::uint8_t type = CanopenPdo::by_the_profile;
  };

  explicit CanopenPdos(const Kind& kind);

  void reset();  ///< as delivered
  const Setup& setup() const { return pdos_; }
  void restore(const Setup& setup) { pdos_ = setup; }
  std::size_t size() const { return kind_.delivered.size(); }
  const CanopenPdo& operator[](std::size_t pdo) const { return pdos_[pdo]; }

  /// Empty: not an object of these.
  std::optional<wire::canopen::SdoValue> read(const wire::canopen::ObjectEntry& entry) const;
  /// Empty: not an object of these, or one that cannot be set; else the code of the refusal, 0 for
  /// none.
  std::optional<std::uint32_t> write(const wire::canopen::SdoWrite& request);
  /// How the PDO of a parameter (1400h, 1800h and following) is set up, for a person.
  std::string in_words(const wire::canopen::ObjectEntry& parameter) const;

 private:
  bool times_are_there() const { return kind_.direction == Direction::sent; }
  std::uint32_t set_parameter(CanopenPdo& pdo, const wire::canopen::SdoWrite& request) const;
  std::uint32_t set_mapping(CanopenPdo& pdo, const wire::canopen::SdoWrite& request) const;
  bool may_be_mapped(std::uint32_t object) const;

  Kind kind_;
  std::uint16_t parameters_, mappings_;
  Setup pdos_{};
};

}  // namespace drydock::emulate
