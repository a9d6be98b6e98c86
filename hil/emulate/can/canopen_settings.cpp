#include "hil/emulate/can/canopen_settings.hpp"

#include "hil/emulate/can/canopen_codes.hpp"

namespace drydock::emulate {
namespace {

using wire::canopen::ObjectEntry;
using wire::canopen::SdoValue;
using wire::canopen::SdoWrite;

bool is_array(std::uint16_t index) {
  return index == cia301::consumer_heartbeat || index == cia301::error_behaviour;
}

/// An 11-bit identifier of a message that this node may use so; it makes no SYNC (bit 30).
bool may_be(std::uint32_t cob_id, std::uint32_t flags) {
  const std::uint32_t id = cob_id & CanopenSettings::id_bits;
  return (cob_id & ~(flags | CanopenSettings::id_bits)) == 0 && id >= 0x080 && id < 0x700;
}

std::uint32_t set_id(std::uint32_t& cob_id, std::uint32_t wanted, std::uint32_t flags) {
  if (!may_be(wanted, flags)) return sdo::beyond_range;
  cob_id = wanted;
  return sdo::taken;
}

}  // namespace

std::optional<SdoValue> read(const CanopenSettings& settings, const ObjectEntry& entry) {
  const auto value = [&](std::uint32_t v, std::uint8_t size) {
    return SdoValue{0, entry, v, size};
  };
  if (is_array(entry.index) && entry.subindex == 0) return value(1, 1);
  if (entry.subindex != (is_array(entry.index) ? 1 : 0)) return {};
  switch (entry.index) {
    case cia301::sync_id: return value(settings.sync_id, 4);
    case cia301::guard_time: return value(settings.guard_ms, 2);
    case cia301::life_factor: return value(settings.life_factor, 1);
    case cia301::emergency_id: return value(settings.emergency_id, 4);
    case cia301::consumer_heartbeat: return value(settings.watched, 4);
    case cia301::heartbeat: return value(settings.heartbeat_ms, 2);
    case cia301::error_behaviour: return value(settings.when_lost, 1);
    default: return {};
  }
}

std::optional<std::uint32_t> write(CanopenSettings& settings, const SdoWrite& request) {
  const auto now = read(settings, request.entry);
  if (!now || (is_array(request.entry.index) && request.entry.subindex == 0)) return {};
  if (request.size != now->size) return sdo::wrong_length;
  switch (request.entry.index) {
    case cia301::sync_id: return set_id(settings.sync_id, request.value, 0);
    case cia301::guard_time: settings.guard_ms = static_cast<std::uint16_t>(request.value); break;
    case cia301::life_factor:
      settings.life_factor = static_cast<std::uint8_t>(request.value);
      break;
    case cia301::emergency_id:
      return set_id(settings.emergency_id, request.value, CanopenSettings::invalid_bit);
    case cia301::consumer_heartbeat:
      if (request.value >> 16 > 127) return sdo::beyond_range;
      settings.watched = request.value;
      break;
    case cia301::heartbeat:
      settings.heartbeat_ms = static_cast<std::uint16_t>(request.value);
      break;
    default:
      if (request.value > CanopenSettings::to_stopped) return sdo::beyond_range;
      settings.when_lost = static_cast<std::uint8_t>(request.value);
  }
  return sdo::taken;
}

}  // namespace drydock::emulate
