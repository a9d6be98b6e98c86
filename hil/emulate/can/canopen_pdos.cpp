#include "hil/emulate/can/canopen_pdos.hpp"

#include <algorithm>

namespace drydock::emulate {
namespace {

using wire::canopen::ObjectEntry;
using wire::canopen::SdoValue;
using wire::canopen::SdoWrite;

constexpr std::uint32_t taken = 0, wrong_size = 0x06070010, out_of_range_value = 0x06090030,
                        cannot_be_mapped = 0x06040041;

}  // namespace

void CanopenPdos::reset(std::uint8_t type) {
  pdos_.fill({});
  for (Pdo& pdo : pdos_) pdo.type = type;
}

std::uint32_t CanopenPdos::id(std::size_t pdo) const {
  constexpr std::uint32_t apart = 0x100;
  return first_id_ + apart * static_cast<std::uint32_t>(pdo);
}

bool CanopenPdos::any_synchronous(std::size_t count) const {
  return std::any_of(pdos_.begin(), pdos_.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Pdo& pdo) { return pdo.is_synchronous(); });
}

bool CanopenPdos::any_by_time(std::size_t count) const {
  return std::any_of(pdos_.begin(), pdos_.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Pdo& pdo) { return !pdo.is_synchronous(); });
}

bool CanopenPdos::due_on_sync(std::size_t place) {
  Pdo& pdo = pdos_[place];
  if (!pdo.is_synchronous() || ++pdo.syncs < pdo.type) return false;
  pdo.syncs = 0;
  return true;
}

std::optional<SdoValue> CanopenPdos::read(const ObjectEntry& entry,
                                          std::span<const PdoMapping> mappings) const {
  const std::size_t place = entry.index & 0xFF;
  const unsigned group = entry.index & 0xFF00;
  if ((group != parameters_ && group != mappings_) || place >= mappings.size()) return {};
  const Pdo& pdo = pdos_[place];
  const auto value = [&](std::size_t v, std::uint8_t size) {
    return SdoValue{0, entry, static_cast<std::uint32_t>(v), size};
  };
  if (group == mappings_) {
    const PdoMapping mapping = mappings[place];
    if (entry.subindex == 0) return value(pdo.mapped ? mapping.size() : 0, 1);
    if (entry.subindex > mapping.size()) return {};
    return value(mapping[entry.subindex - 1u], 4);
  }
  switch (entry.subindex) {
    case 0: return value(2, 1);
    case 1: return value(id(place) | (pdo.valid ? 0 : invalid_bit), 4);
    case 2: return value(pdo.type, 1);
    default: return {};
  }
}

std::optional<std::uint32_t> CanopenPdos::write(const SdoWrite& request,
                                                std::span<const PdoMapping> mappings) {
  const std::size_t place = request.entry.index & 0xFF;
  const unsigned group = request.entry.index & 0xFF00;
  if (place >= mappings.size() || !read(request.entry, mappings)) return {};
  if (group == mappings_) return set_mapping(pdos_[place], mappings[place], request);
  if (request.entry.subindex == 0) return {};
  return set_parameter(pdos_[place], place, request);
}

std::uint32_t CanopenPdos::set_parameter(Pdo& pdo, std::size_t place, const SdoWrite& request) {
  if (request.entry.subindex == 1) {
    if (request.size != 4) return wrong_size;
    if ((request.value & id_bits) != id(place)) return out_of_range_value;
    pdo.valid = (request.value & invalid_bit) == 0;
    return taken;
  }
  if (request.size != 1) return wrong_size;
  constexpr std::uint32_t first_event_driven = 0xFE;
  const bool synchronous = request.value >= on_each_sync && request.value <= last_synchronous;
  if (!synchronous && request.value < first_event_driven) return out_of_range_value;
  pdo.type = static_cast<std::uint8_t>(request.value);
  pdo.syncs = 0;
  return taken;
}

/// Written again by masters that write all they know. Another mapping is refused.
std::uint32_t CanopenPdos::set_mapping(Pdo& pdo, PdoMapping mapping, const SdoWrite& request) {
  if (request.entry.subindex == 0) {
    if (request.size != 1) return wrong_size;
    if (request.value != 0 && request.value != mapping.size()) return cannot_be_mapped;
    pdo.mapped = request.value != 0;
    return taken;
  }
  if (request.size != 4) return wrong_size;
  return request.value == mapping[request.entry.subindex - 1u] ? taken : cannot_be_mapped;
}

}  // namespace drydock::emulate
