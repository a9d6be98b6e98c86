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

/// A key that stands for all items of its group, or of all groups.
bool is_wildcard(std::uint32_t key) { return (key & 0xFFFF) == 0xFFFF; }
bool is_meant(std::uint32_t key, std::uint32_t wildcard) {
  constexpr std::uint32_t every_group = 0xFFF;
  const std::uint32_t group = wildcard >> 16 & 0xFFF;
  return key != 0 && (group == every_group || (key >> 16 & 0xFF) == (group & 0xFF));
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

std::string unknown(std::uint32_t key) { return fmt::format("unknown key {:08X}h", key); }

void delete_meant(std::uint32_t wildcard, Transaction::Changes& changes) {
  for (std::size_t item = 0; item < item_count(); ++item)
    if (is_meant(facts_of(item).key, wildcard)) changes[item].reset();
}

/// Reads pairs of key and value, or keys alone. Returns the words that tell what is wrong with the
/// first that is none; empty: nothing.
std::string read_changes(wire::Bytes data, Transaction::Kind kind, Transaction::Changes& changes) {
  for (std::size_t count = 1; !data.empty(); ++count) {
    if (count > most_in_one) return "more than 64 keys";
    if (data.size() < key_size) return "half a key";
    const auto key = load_le<std::uint32_t>(data, 0);
    const std::size_t size = kind == Transaction::Kind::set ? size_of_key(key) : 0;
    const auto item = item_of_key(key);
    if (!item && kind == Transaction::Kind::deletion && is_wildcard(key)) {
      delete_meant(key, changes);
      data = data.subspan(key_size);
      continue;
    }
    if (!item) return unknown(key);
    if (data.size() < key_size + size) return fmt::format("half a value of key {:08X}h", key);
    auto& change = changes[*item];
    change.reset();
    if (kind == Transaction::Kind::set) change = value_at(data.subspan(key_size), size);
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
  if (payload.size() > head + key_size * most_in_one) return refuse("more than 64 keys");
  const std::uint8_t layer = payload[1];
  ValueWriter answer(payload, load_le<std::uint16_t>(payload, 2));
  for (std::size_t at = head; at < payload.size(); at += key_size) {
    const auto key = load_le<std::uint32_t>(payload, at);
    if (!is_wildcard(key) && !item_of_key(key)) return refuse(unknown(key));
    for (std::size_t item = 0; item < item_count(); ++item) {
      const std::uint32_t its = facts_of(item).key;
      if (is_wildcard(key) ? !is_meant(its, key) : its != key) continue;
      if (const auto value = value_in(settings_, layer, item)) answer.add(its, *value);
    }
  }
  if (!answer.any())
    return refuse(
        fmt::format("key {:08X}h: nothing in layer {}", load_le<std::uint32_t>(payload, 4), layer));
  reply(ubx::cfg_valget, answer.payload());
  return Verdict::ack;
}

Verdict UbloxDialogue::on_valset(wire::Bytes payload) {
  return change(payload, Transaction::Kind::set);
}

Verdict UbloxDialogue::on_valdel(wire::Bytes payload) {
  return change(payload, Transaction::Kind::deletion);
}

Verdict UbloxDialogue::refuse(std::string why) {
  transaction_.cancel();
  note_ = std::move(why);
  return Verdict::nak;
}

/// All or nothing. With version 1 nothing takes effect before the message that ends its
/// transaction.
Verdict UbloxDialogue::change(wire::Bytes payload, Transaction::Kind kind) {
  constexpr std::uint8_t newest_version = 1;
  constexpr unsigned set_layers = 0b111, deletion_layers = 0b110;
  if (payload.size() < head || payload[0] > newest_version) return refuse("");
  const std::uint8_t layers = payload[1];
  const bool deletes = kind == Transaction::Kind::deletion;
  const bool has_layer = (layers & (deletes ? deletion_layers : set_layers)) != 0;
  if (!has_layer || (layers & ~set_layers) != 0)
    return refuse(fmt::format("layers {:02X}h", layers));
  const std::uint8_t action =
      payload[0] == newest_version ? payload[2] : std::uint8_t{Transaction::alone};
  if (!transaction_.takes(kind, action, layers))
    return refuse(fmt::format("no transaction that goes on with action {}", action));
  if (auto wrong = read_changes(payload.subspan(head), kind, transaction_.changes());
      !wrong.empty())
    return refuse(std::move(wrong));
  if (transaction_.waits()) return Verdict::ack;
  const Transaction::Changes changes = transaction_.end();
  return apply(changes, layers);
}

/// Only values for RAM are checked.
Verdict UbloxDialogue::apply(const Transaction::Changes& changes, std::uint8_t layers) {
  const bool in_force = (layers & 1u) != 0;
  for (const auto& [item, value] : changes)
    if (in_force && value && !settings_.allows(item, *value))
      return refuse(fmt::format("key {:08X}h cannot be {}", facts_of(item).key, *value));
  for (const auto& change : changes) {
    each_layer(layers, [&](Saved where) { settings_.save(where, change.first, change.second); });
    if (in_force && change.second) put(change.first, *change.second);
  }
  note_ = fmt::format("{} values, {} baud, an epoch each {:.0f} ms{}", changes.size(),
                      settings_[baud], settings_.period_s() * 1e3, layers >> 1 ? ", saved" : "");
  return Verdict::ack;
}

}  // namespace drydock::emulate::ublox
