#include "hil/emulate/ublox/ublox_settings.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/wire/bytes.hpp"

namespace drydock::emulate::ublox {
namespace {

constexpr std::array<std::uint64_t, 8> baud_rates{4800,  9600,   19200,  38400,
                                                  57600, 115200, 230400, 460800};
constexpr std::uint64_t fastest_m8_ms = 50, unknown_model = 1, last_m8_model = 10;

bool in_mask(std::uint32_t mask, std::size_t item) {
  return (mask >> facts_of(item).group & 1u) != 0;
}

}  // namespace

UbloxSettings::UbloxSettings(Model model, double rate_hz, std::shared_ptr<Memory> memory)
    : model_(model), memory_(std::move(memory)) {
  for (std::size_t item = 0; item < item_count(); ++item)
    delivered_.push_back(model == Model::m8 ? facts_of(item).m8 : facts_of(item).f9);
  delivered_[measure_ms] = static_cast<std::uint64_t>(std::lround(1000 / rate_hz));
  saved_.fill(Layer(item_count()));
  if (memory_) read_flash();
  restart();
}

void UbloxSettings::deliver_baud(unsigned rate) {
  delivered_[baud] = rate;
  ram_[baud] = as_after_power(baud);
}

std::optional<std::uint64_t> UbloxSettings::saved(Saved where, std::size_t item) const {
  return saved_[static_cast<std::size_t>(where)][item];
}

bool UbloxSettings::allows(std::size_t item, std::uint64_t value) const {
  const ItemFacts facts = facts_of(item);
  if (value < facts.least || value > facts.most) return false;
  const bool m8 = model_ == Model::m8;
  if (item == baud)
    return std::ranges::find(baud_rates, value) != baud_rates.end() || value == facts.most;
  if (item == measure_ms) return !m8 || value >= fastest_m8_ms;
  if (item == dynamic_model) return value != unknown_model && (!m8 || value <= last_m8_model);
  return true;
}

void UbloxSettings::save(Saved where, std::size_t item, std::optional<std::uint64_t> value) {
  layer(where)[item] = value;
  if (where == Saved::flash) write_flash();
}

std::uint64_t UbloxSettings::as_after_power(std::size_t item) const {
  for (const Saved where : {Saved::battery_backed, Saved::flash})
    if (const auto value = saved(where, item); value && allows(item, *value)) return *value;
  return delivered_[item];
}

void UbloxSettings::restart() { load_groups(~0u); }

void UbloxSettings::save_groups(std::uint32_t mask, Saved where) {
  for (std::size_t item = 0; item < item_count(); ++item)
    if (in_mask(mask, item)) layer(where)[item] = ram_[item];
  write_flash();
}

void UbloxSettings::clear_groups(std::uint32_t mask, Saved where) {
  for (std::size_t item = 0; item < item_count(); ++item)
    if (in_mask(mask, item)) layer(where)[item].reset();
  write_flash();
}

void UbloxSettings::load_groups(std::uint32_t mask) {
  ram_.resize(item_count());
  for (std::size_t item = 0; item < item_count(); ++item)
    if (in_mask(mask, item)) ram_[item] = as_after_power(item);
}

double UbloxSettings::period_s() const {
  return static_cast<double>(ram_[measure_ms] * ram_[measures_per_epoch]) * 1e-3;
}

double UbloxSettings::delivered_period_s() const {
  return static_cast<double>(delivered_[measure_ms] * delivered_[measures_per_epoch]) * 1e-3;
}

/// Index (two bytes) and value (eight bytes) of each item that is in flash.
void UbloxSettings::write_flash() const {
  if (!memory_) return;
  memory_->bytes.clear();
  for (std::size_t item = 0; item < item_count(); ++item) {
    const auto value = saved(Saved::flash, item);
    if (!value) continue;
    std::array<std::uint8_t, 10> entry{};
    wire::store_le<std::uint16_t>(entry, 0, static_cast<std::uint16_t>(item));
    wire::store_le<std::uint64_t>(entry, 2, *value);
    memory_->bytes.insert(memory_->bytes.end(), entry.begin(), entry.end());
  }
}

void UbloxSettings::read_flash() {
  const std::span<const std::uint8_t> bytes = memory_->bytes;
  for (std::size_t at = 0; at + 10 <= bytes.size(); at += 10)
    layer(Saved::flash)[wire::load_le<std::uint16_t>(bytes, at)] =
        wire::load_le<std::uint64_t>(bytes, at + 2);
}

}  // namespace drydock::emulate::ublox
