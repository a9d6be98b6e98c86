#include <cstring>
#include <type_traits>

#include "hil/emulate/can/canopen_device.hpp"
#include "rig_config/fault_vocabulary.hpp"

/// The object dictionary of an emulated node (CiA 301, 7.5.2).
namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;

constexpr std::string_view hardware_text = "emulated", software_text = "1.0";
constexpr std::uint32_t revision = 0x00010000, save = 0x65766173,
                        load = 0x64616F6C;  // "save" "load"
constexpr std::uint32_t on_command = 1;

/// What a node keeps without power.
struct Kept {
  CanopenSettings settings;
  CanopenPdos::Setup sent, taken;
};
static_assert(std::is_trivially_copyable_v<Kept>);

}  // namespace

/// As saved, else as delivered.
void CanopenDevice::recall() {
  settings_ = {};
  settings_.emergency_id = canopen::emergency_base + node_;
  settings_.when_lost = profile_.when_lost;
  tpdos_.reset();
  rpdos_.reset();
  if (memory_->bytes.size() != sizeof(Kept)) return;
  Kept kept;
  std::memcpy(&kept, memory_->bytes.data(), sizeof(Kept));
  settings_ = kept.settings;
  tpdos_.restore(kept.sent);
  rpdos_.restore(kept.taken);
}

void CanopenDevice::keep() {
  const Kept kept{settings_, tpdos_.setup(), rpdos_.setup()};
  memory_->bytes.resize(sizeof(Kept));
  std::memcpy(memory_->bytes.data(), &kept, sizeof(Kept));
}

std::optional<CanopenDevice::Object> CanopenDevice::find_general(const Entry& entry) const {
  const auto of = [&](auto... values) -> std::optional<Object> {
    const std::array<Object, sizeof...(values)> all{values...};
    if (entry.subindex >= all.size()) return {};
    return all.at(entry.subindex);
  };
  switch (entry.index) {
    case cia301::device_type: return of(Object{profile_.device_type, 4});
    case cia301::error_register: return of(Object{error_register_, 1});
    case cia301::errors:
      if (entry.subindex == 0) return Object{static_cast<std::uint32_t>(errors_.count()), 1};
      if (entry.subindex > errors_.count()) return {};
      return Object{errors_[entry.subindex - 1u], 4};
    case cia301::name: return of(Object{0, 0, profile_.name});
    case cia301::hardware: return of(Object{0, 0, hardware_text});
    case cia301::software: return of(Object{0, 0, software_text});
    case cia301::store:
    case cia301::restore: return of(Object{1, 1}, Object{on_command, 4});
    case cia301::identity:  // no real maker and product
      return of(Object{4, 1}, Object{0, 4}, Object{0, 4}, Object{revision, 4},
                Object{serial_number_, 4});
    default: return {};
  }
}

std::optional<CanopenDevice::Object> CanopenDevice::find(const Entry& entry) const {
  if (entry.index >= cia301::first_of_maker) return object(entry);
  if (const auto found = find_general(entry)) return found;
  for (const auto& found :
       {emulate::read(settings_, entry), tpdos_.read(entry), rpdos_.read(entry)})
    if (found) return Object{found->value, found->size};
  return {};
}

/// The code for an entry that is not there: of an object that is, only the sub-index is wrong.
std::uint32_t CanopenDevice::missing(const Entry& entry) const {
  if (entry.index == cia301::errors && entry.subindex <= CanopenErrors::most) return sdo::no_data;
  for (unsigned sub = 0; sub < 0xFF; ++sub)
    if (find({entry.index, static_cast<std::uint8_t>(sub)})) return sdo::no_such_subindex;
  return sdo::no_such_object;
}

CanopenDevice::Found CanopenDevice::read_entry(const Entry& entry) const {
  const auto found = find(entry);
  return found ? Found{*found} : Found{{}, missing(entry)};
}

std::uint32_t CanopenDevice::write_entry(const canopen::SdoWrite& request, Stamp now, Wire& out) {
  if (condition().under(FaultKind::nak)) return sdo::not_in_this_state;
  const auto there = find(request.entry);
  if (!there) return missing(request.entry);
  canopen::SdoWrite whole = request;
  if (!request.sized && there->text.empty()) {
    whole.size = there->size;
    whole.value &= 0xFFFFFFFFu >> 8 * (4 - there->size);
  }
  return set(whole, now, out).value_or(sdo::read_only);
}

std::optional<std::uint32_t> CanopenDevice::set(const canopen::SdoWrite& request, Stamp now,
                                                Wire& out) {
  if (request.entry.index < cia301::first_of_maker) {
    if (const auto code = set_general(request, out)) return code;
    if (const auto code = set_pdo(request, now, out)) return code;
    const auto code = write(settings_, request);
    if (code != sdo::taken) return code;
    if (request.entry.index == cia301::consumer_heartbeat) life_.forget_heartbeat();
    if (request.entry.index != cia301::heartbeat) return code;
    next_heartbeat_.reset();
    if (settings_.heartbeat_ms > 0)
      next_heartbeat_ = now + std::chrono::milliseconds{settings_.heartbeat_ms};
    return code;
  }
  if (!takes(request.entry)) return {};
  if (request.size != find(request.entry)->size) return sdo::wrong_length;
  const auto code = put(request.entry, request.value);
  if (code == sdo::taken) act(now, out);
  return code;
}

/// Commands of the signature, and the number of errors, which 0 clears.
std::optional<std::uint32_t> CanopenDevice::set_general(const canopen::SdoWrite& request,
                                                        Wire& out) {
  const auto [index, subindex] = request.entry;
  if (index == cia301::errors && subindex == 0) {
    if (request.size != 1) return sdo::wrong_length;
    if (request.value != 0) return sdo::beyond_range;
    errors_.clear();
    return sdo::taken;
  }
  if ((index != cia301::store && index != cia301::restore) || subindex != 1) return {};
  if (request.size != 4) return sdo::wrong_length;
  if (request.value != (index == cia301::store ? save : load)) return sdo::wrong_signature;
  if (index == cia301::store) {
    keep();
    out.tell("to save its settings");
  } else {
    memory_->bytes.clear();  // it counts from the next reset on
    out.tell("to be as delivered from its next reset on");
  }
  return sdo::taken;
}

/// A node that sampled on SYNC alone begins to sample by its own time from now on.
std::optional<std::uint32_t> CanopenDevice::set_pdo(const canopen::SdoWrite& request, Stamp now,
                                                    Wire& out) {
  const bool rested = !any_at_samples(tpdos_);
  const bool sent = tpdos_.read(request.entry).has_value();
  CanopenPdos& pdos = sent ? tpdos_ : rpdos_;
  const auto code = pdos.write(request);
  const bool is_mapping = (request.entry.index & 0x0200) != 0;  // 1600h, 1A00h: before it is on
  if (code == sdo::taken && !is_mapping) out.tell(pdos.in_words(request.entry));
  if (rested && any_at_samples(tpdos_)) go_on_at_whole_multiples(rate_hz(), now);
  if (code == sdo::taken && is_operational()) schedule_.begin(tpdos_, now);
  return code;
}

}  // namespace drydock::emulate
