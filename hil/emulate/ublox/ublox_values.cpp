#include <fmt/format.h>

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;
using wire::load_le;

namespace {

constexpr std::size_t head = 4, key_size = 4, most_in_one = 64;
constexpr std::uint8_t layer_ram = 0, layer_backed = 1, layer_flash = 2, layer_delivered = 7;

std::uint64_t value_at(wire::Bytes data, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{data[i]} << 8 * i;
  return value;
}

/// A key that stands for all items of its group.
bool is_group(std::uint32_t key) { return (key & 0xFFFF) == 0xFFFF; }
bool is_in_group(std::uint32_t key, std::uint32_t group) {
  return key != 0 && (key >> 16 & 0xFF) == (group >> 16 & 0xFF);
}

std::optional<std::uint64_t> value_in(const UbloxSettings& settings, std::uint8_t layer,
                                      std::size_t item) {
  switch (layer) {
    case layer_ram: return settings[item];
    case layer_backed: return settings.saved(Saved::battery_backed, item);
    case layer_flash: return settings.saved(Saved::flash, item);
    case layer_delivered: return settings.delivered(item);
    default: return {};
  }
}

/// Calls `take(item, value)` for each pair of key and value. Returns the words that tell what is
/// wrong with the first pair that is none, or that `take` refuses; empty: nothing.
template <class Take>
std::string each_value(wire::Bytes data, Take&& take) {
  while (!data.empty()) {
    if (data.size() < key_size) return "half a key";
    const auto key = load_le<std::uint32_t>(data, 0);
    const std::size_t size = size_of_key(key);
    const auto item = item_of_key(key);
    if (!item) return fmt::format("unknown key {:08X}h", key);
    if (data.size() < key_size + size) return fmt::format("half a value of key {:08X}h", key);
    const std::uint64_t value = value_at(data.subspan(key_size), size);
    if (!take(*item, value)) return fmt::format("key {:08X}h cannot be {}", key, value);
    data = data.subspan(key_size + size);
  }
  return {};
}

/// Calls `save(where)` for each saved layer of a mask.
template <class Save>
void each_layer(std::uint8_t mask, Save&& save) {
  if (mask >> layer_backed & 1u) save(Saved::battery_backed);
  if (mask >> layer_flash & 1u) save(Saved::flash);
}

/// Writes pairs of key and value behind a head.
class ValueWriter {
 public:
  ValueWriter(wire::Bytes payload, std::uint16_t skip) : skip_(skip) {
    answer_ = {1, payload[1], payload[2], payload[3]};
  }
  void add(std::uint32_t key, std::uint64_t value) {
    if (found_++ < skip_ || written_ == most_in_one) return;
    ++written_;
    for (std::size_t i = 0; i < key_size; ++i) put(key >> 8 * i);
    for (std::size_t i = 0; i < size_of_key(key); ++i) put(value >> 8 * i);
  }
  bool any() const { return written_ > 0; }
  wire::Bytes payload() const { return wire::Bytes{answer_}.first(size_); }

 private:
  void put(std::uint64_t byte) { answer_[size_++] = static_cast<std::uint8_t>(byte); }

  std::array<std::uint8_t, head + most_in_one*(key_size + 8)> answer_{};
  std::size_t size_ = head;
  std::size_t skip_, found_ = 0, written_ = 0;
};

}  // namespace

Verdict UbloxDialogue::on_valget(wire::Bytes payload) {
  if (payload.size() < head + key_size || payload.size() % key_size != 0 || payload[0] != 0)
    return Verdict::nak;
  ValueWriter answer(payload, load_le<std::uint16_t>(payload, 2));
  for (std::size_t at = head; at < payload.size(); at += key_size) {
    const auto key = load_le<std::uint32_t>(payload, at);
    const std::size_t before = is_group(key) ? 1 : item_of_key(key).has_value();
    if (before == 0) return Verdict::nak;
    for (std::size_t item = 0; item < item_count(); ++item) {
      const std::uint32_t its = facts_of(item).key;
      if (is_group(key) ? !is_in_group(its, key) : its != key) continue;
      if (const auto value = value_in(settings_, payload[1], item)) answer.add(its, *value);
    }
  }
  if (!answer.any()) return Verdict::nak;
  reply(ubx::cfg_valget, answer.payload());
  return Verdict::ack;
}

/// All or nothing. A transaction is carried out at once.
Verdict UbloxDialogue::on_valset(wire::Bytes payload) {
  constexpr std::uint8_t newest_version = 1, known_layers = 0b111;
  if (payload.size() < head || payload[0] > newest_version) return Verdict::nak;
  const std::uint8_t layers = payload[1];
  if (layers == 0 || (layers & ~known_layers) != 0) return Verdict::nak;
  const wire::Bytes data = payload.subspan(head);
  std::size_t values = 0;
  note_ = each_value(data, [&](std::size_t item, std::uint64_t value) {
    ++values;
    return settings_.allows(item, value);
  });
  if (note_.empty() && values > most_in_one) note_ = fmt::format("{} keys, at most 64", values);
  if (!note_.empty()) return Verdict::nak;
  each_value(data, [&](std::size_t item, std::uint64_t value) {
    each_layer(layers, [&](Saved where) { settings_.save(where, item, value); });
    return !(layers & 1u) || put(item, value);
  });
  note_ = fmt::format("{} values, {} baud, an epoch each {:.0f} ms{}", values, settings_[baud],
                      settings_.period_s() * 1e3, layers >> 1 ? ", saved" : "");
  return Verdict::ack;
}

Verdict UbloxDialogue::on_valdel(wire::Bytes payload) {
  if (payload.size() < head + key_size || payload.size() % key_size != 0) return Verdict::nak;
  for (std::size_t at = head; at < payload.size(); at += key_size)
    if (!item_of_key(load_le<std::uint32_t>(payload, at))) return Verdict::nak;
  for (std::size_t at = head; at < payload.size(); at += key_size)
    each_layer(payload[1], [&](Saved where) {
      settings_.save(where, *item_of_key(load_le<std::uint32_t>(payload, at)), std::nullopt);
    });
  return Verdict::ack;
}

}  // namespace drydock::emulate::ublox
