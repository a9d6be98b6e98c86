#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// The contents of a PDO in the form of 1A00h: index << 16 | subindex << 8 | bits.
using PdoMapping = std::span<const std::uint32_t>;

/// How a master has set up the PDOs of one direction (CiA 301: 1800h and 1A00h on, or 1400h and
/// 1600h on). A master may switch each off and on by bit 31 of its COB-ID, choose its transmission
/// type, and write the mapping again; the identifiers and the mappings stay those of the device.
class CanopenPdos {
 public:
  static constexpr std::size_t most = 4;
  static constexpr std::uint8_t on_each_sync = 1, last_synchronous = 240, by_the_profile = 0xFE;

  struct Pdo {
    bool valid = true, mapped = true;
    std::uint8_t type = by_the_profile;
    std::uint8_t syncs = 0;  ///< since it was sent
    bool is_synchronous() const { return type >= on_each_sync && type <= last_synchronous; }
    bool is_on() const { return valid && mapped; }
  };

  /// `first_id`: COB-ID of the first one on this node; the next ones follow each 100h later.
  CanopenPdos(std::uint16_t parameters, std::uint16_t mappings, std::uint32_t first_id)
      : parameters_(parameters), mappings_(mappings), first_id_(first_id) {}

  void reset(std::uint8_t type);
  std::uint32_t id(std::size_t pdo) const;
  const Pdo& operator[](std::size_t pdo) const { return pdos_[pdo]; }
  bool any_synchronous(std::size_t count) const;
  bool any_by_time(std::size_t count) const;
  /// Counts a SYNC. True: it is the one for this PDO.
  bool due_on_sync(std::size_t pdo);

  /// Empty: not an object of these.
  std::optional<wire::canopen::SdoValue> read(const wire::canopen::ObjectEntry& entry,
                                              std::span<const PdoMapping> mappings) const;
  /// Empty: not an object of these, or one that cannot be set; else the code of the refusal, 0 for
  /// none.
  std::optional<std::uint32_t> write(const wire::canopen::SdoWrite& request,
                                     std::span<const PdoMapping> mappings);

 private:
  static constexpr std::uint32_t invalid_bit = 1U << 31, id_bits = 0x3FFFFFFF;

  std::uint32_t set_parameter(Pdo& pdo, std::size_t place, const wire::canopen::SdoWrite& request);
  static std::uint32_t set_mapping(Pdo& pdo, PdoMapping mapping,
                                   const wire::canopen::SdoWrite& request);

  std::uint16_t parameters_, mappings_;
  std::uint32_t first_id_;
  std::array<Pdo, most> pdos_{};
};

/// Passes on what a device sends, without the PDOs that are not to go now.
class ChosenPdos final : public Wire {
 public:
  ChosenPdos(Wire& out, const CanopenPdos& pdos, std::array<bool, CanopenPdos::most> goes)
      : out_(out), pdos_(pdos), goes_(goes) {}
  void send(wire::Bytes bytes) override { out_.send(bytes); }
  void send(const wire::CanFrame& frame) override {
    for (std::size_t i = 0; i < goes_.size(); ++i)
      if (frame.id == pdos_.id(i) && !goes_[i]) return;
    out_.send(frame);
  }
  void tell(std::string_view what) override { out_.tell(what); }

 private:
  Wire& out_;
  const CanopenPdos& pdos_;
  std::array<bool, CanopenPdos::most> goes_;
};

}  // namespace drydock::emulate
