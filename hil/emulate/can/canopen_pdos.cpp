#include "hil/emulate/can/canopen_pdos.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hil/emulate/can/canopen_codes.hpp"

namespace drydock::emulate {
namespace {

using wire::canopen::ObjectEntry;
using wire::canopen::SdoValue;
using wire::canopen::SdoWrite;

constexpr std::uint8_t type_subindex = 2, inhibit_subindex = 3, reserved_subindex = 4,
                       timer_subindex = 5;
constexpr std::uint32_t first_sent = 0x180, first_taken = 0x200, apart = 0x100;
constexpr std::size_t most_bits = 64;

/// Identifiers that CiA 301 keeps for other services (its table of restricted COB-IDs).
bool is_restricted(std::uint32_t id) {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr std::array<Range, 7> kept{{{0x000, 0x07F},
                                       {0x101, 0x180},
                                       {0x581, 0x5FF},
                                       {0x601, 0x67F},
                                       {0x6E0, 0x6FF},
                                       {0x701, 0x77F},
                                       {0x780, 0x7FF}}};
  return std::ranges::any_of(kept, [&](const Range& r) { return id >= r.first && id <= r.last; });
}

/// Entries of nothing, for places of a taken PDO that are not for this node (CiA 301: 0001h to
/// 0007h, the data types).
bool is_dummy(std::uint32_t object) {
  constexpr std::array<std::uint32_t, 7> dummies{0x00010001, 0x00020008, 0x00030010, 0x00040020,
                                                 0x00050008, 0x00060010, 0x00070020};
  return (object & 0xFF) % 8 == 0 && std::ranges::find(dummies, object) != dummies.end();
}

std::uint32_t set_cob_id(CanopenPdo& pdo, const SdoWrite& request) {
  if (request.size != 4) return sdo::wrong_length;
  const std::uint32_t id = request.value & CanopenPdo::id_bits;
  const bool stays_valid = pdo.is_valid() && (request.value & CanopenPdo::invalid_bit) == 0;
  const bool is_long = (request.value & CanopenPdo::extended_bit) != 0;
  if (is_long || is_restricted(id) || (stays_valid && id != pdo.id())) return sdo::beyond_range;
  pdo.cob_id = request.value;
  return sdo::taken;
}

std::uint32_t set_type(CanopenPdo& pdo, const SdoWrite& request) {
  if (request.size != 1) return sdo::wrong_length;
  CanopenPdo wanted;
  wanted.type = static_cast<std::uint8_t>(request.value);
  if (!wanted.is_synchronous() && request.value < CanopenPdo::by_the_profile)
    return sdo::beyond_range;
  pdo.type = wanted.type;
  return sdo::taken;
}

}  // namespace

std::size_t CanopenPdo::bits() const {
  std::size_t all = 0;
  for (std::size_t i = 0; i < objects; ++i) all += mapping[i] & 0xFF;
  return all;
}

CanopenPdos::CanopenPdos(const Kind& kind)
    : kind_(kind),
      parameters_(kind.direction == Direction::sent ? 0x1800 : 0x1400),
      mappings_(kind.direction == Direction::sent ? 0x1A00 : 0x1600) {
  reset();
}

void CanopenPdos::reset() {
  const std::uint32_t first = kind_.direction == Direction::sent ? first_sent : first_taken;
  for (std::size_t i = 0; i < size(); ++i) {
    const PdoMapping& mapping = kind_.delivered[i];
    pdos_[i] = {};
    pdos_[i].cob_id = first + apart * static_cast<std::uint32_t>(i) + kind_.node;
    pdos_[i].type = kind_.type;
    pdos_[i].objects = static_cast<std::uint8_t>(mapping.size());
    std::ranges::copy(mapping, pdos_[i].mapping.begin());
  }
}

std::optional<SdoValue> CanopenPdos::read(const ObjectEntry& entry) const {
  const std::size_t place = entry.index & 0xFF;
  const unsigned group = entry.index & 0xFF00;
  if ((group != parameters_ && group != mappings_) || place >= size()) return {};
  const CanopenPdo& pdo = pdos_[place];
  const auto value = [&](std::uint32_t v, std::uint8_t bytes) {
    return SdoValue{0, entry, v, bytes};
  };
  if (group == mappings_) {
    if (entry.subindex == 0) return value(pdo.objects, 1);
    if (entry.subindex > CanopenPdo::most_objects) return {};
    return value(pdo.mapping[entry.subindex - 1u], 4);
  }
  const bool timed = times_are_there();
  switch (entry.subindex) {
    case 0: return value(timed ? timer_subindex : type_subindex, 1);
    case 1: return value(pdo.cob_id, 4);
    case type_subindex: return value(pdo.type, 1);
    case inhibit_subindex: return timed ? std::optional(value(pdo.inhibit, 2)) : std::nullopt;
    case timer_subindex: return timed ? std::optional(value(pdo.timer_ms, 2)) : std::nullopt;
    default: return {};
  }
}

std::optional<std::uint32_t> CanopenPdos::write(const SdoWrite& request) {
  const std::size_t place = request.entry.index & 0xFF;
  const unsigned group = request.entry.index & 0xFF00;
  if (place >= size() || !read(request.entry)) return {};
  if (group == mappings_) return set_mapping(pdos_[place], request);
  if (request.entry.subindex == 0) return {};
  return set_parameter(pdos_[place], request);
}

std::string CanopenPdos::in_words(const ObjectEntry& parameter) const {
  const std::size_t place = parameter.index & 0xFF;
  const CanopenPdo& pdo = pdos_.at(place);
  const auto name =
      fmt::format("{}PDO{}", kind_.direction == Direction::sent ? 'T' : 'R', place + 1);
  if (!pdo.is_on()) return name + " off";
  std::string text = fmt::format("{} {:X}h, type {}", name, pdo.id(), pdo.type);
  if (pdo.timer_ms != 0) text += fmt::format(", event timer {} ms", pdo.timer_ms);
  if (pdo.inhibit != 0) text += fmt::format(", inhibit time {} us", pdo.inhibit_time().count());
  for (std::size_t i = 0; i < pdo.objects; ++i)
    text += fmt::format("{} {:X}h:{}", i == 0 ? ":" : ",", pdo.mapping[i] >> 16,
                        pdo.mapping[i] >> 8 & 0xFF);
  return text;
}

std::uint32_t CanopenPdos::set_parameter(CanopenPdo& pdo, const SdoWrite& request) const {
  if (request.entry.subindex == 1) return set_cob_id(pdo, request);
  if (request.entry.subindex == type_subindex) return set_type(pdo, request);
  if (request.size != 2) return sdo::wrong_length;
  const auto wanted = static_cast<std::uint16_t>(request.value);
  if (request.entry.subindex == timer_subindex) {
    pdo.timer_ms = wanted;
  } else if (pdo.is_valid() && wanted != pdo.inhibit) {
    return sdo::not_in_this_state;
  } else {
    pdo.inhibit = wanted;
  }
  return sdo::taken;
}

bool CanopenPdos::may_be_mapped(std::uint32_t object) const {
  const bool dummy = kind_.direction == Direction::taken && is_dummy(object);
  return dummy || std::ranges::find(kind_.mappable, object) != kind_.mappable.end();
}

/// CiA 301, 7.5.2.36: switch the PDO off, count to 0, the entries, the count, switch it on.
std::uint32_t CanopenPdos::set_mapping(CanopenPdo& pdo, const SdoWrite& request) const {
  const bool is_count = request.entry.subindex == 0;
  if (request.size != (is_count ? 1 : 4)) return sdo::wrong_length;
  if (pdo.is_valid() || (!is_count && pdo.objects != 0)) return sdo::not_in_this_state;
  if (!is_count) {
    if (!may_be_mapped(request.value)) return sdo::cannot_be_mapped;
    pdo.mapping[request.entry.subindex - 1u] = request.value;
    return sdo::taken;
  }
  if (request.value > CanopenPdo::most_objects) return sdo::pdo_too_long;
  CanopenPdo wanted = pdo;
  wanted.objects = static_cast<std::uint8_t>(request.value);
  for (std::size_t i = 0; i < wanted.objects; ++i)
    if (!may_be_mapped(wanted.mapping[i])) return sdo::cannot_be_mapped;
  if (wanted.bits() > most_bits) return sdo::pdo_too_long;
  pdo.objects = wanted.objects;
  return sdo::taken;
}

}  // namespace drydock::emulate
