#include "hil/emulate/ublox/ublox_items.hpp"

#include <algorithm>
#include <array>

#include "hil/emulate/ublox/ublox_inert_items.hpp"

namespace drydock::emulate::ublox {
namespace {

constexpr std::uint64_t on = 1, off = 0;
constexpr std::uint64_t any = ~std::uint64_t{0};

// In the order of Item. The baud rate and the time between measurements as delivered are those of
// the rig; see UbloxSettings.
constexpr auto items = std::to_array<ItemFacts>({
    {0x40520001, ports, 9600, 38400, 4800, 921600},
    {0x10730001, ports, on, on, 0, 1},
    {0x10730002, ports, on, on, 0, 1},
    {0x10740001, ports, on, on, 0, 1},
    {0x10740002, ports, on, on, 0, 1},
    {0x30210001, navigation, 1000, 1000, 25, 0xFFFF},
    {0x30210002, navigation, 1, 1, 1, 127},
    {0x20210003, navigation, 1, 1, 0, 4},
    {0x20110021, navigation, 0, 0, 0, 12},
    {0x20110011, navigation, 3, 3, 1, 3},
    {0x401100C1, navigation, 0, 0, 0, any},
    {0x401100C2, navigation, 10000, 10000, 0, any},
    {0x201100A4, navigation, 5, 10, 0, any},
    {0x301100B1, navigation, 250, 250, 0, any},
    {0x301100B2, navigation, 250, 250, 0, any},
    {0x301100B3, navigation, 100, 100, 0, any},
    {0x301100B4, navigation, 300, 350, 0, any},
    {0x20250038, navigation, 0, 0, 0, any},
    {0x201100C4, navigation, 60, 60, 0, any},
    {0x201100AA, navigation, 0, 0, 0, any},
    {0x201100AB, navigation, 0, 0, 0, any},
    {0x3025003B, navigation, 0, 0, 0, any},
    {0x2011001C, navigation, 0, 0, 0, any},
    {0x20030001, navigation, 0, 0, 0, 2},
    {0x1031001F, receiver, on, on, 0, 1},
    {0x10310020, receiver, on, off, 0, 1},
    {0x10310021, receiver, off, on, 0, 1},
    {0x10310022, receiver, off, on, 0, 1},
    {0x10310024, receiver, on, on, 0, 1},
    {0x10310025, receiver, on, on, 0, 1},
    {0x10360002, navigation, off, off, 0, 1},
    {0x10360003, navigation, on, off, 0, 1},
    {0x10360004, navigation, on, on, 0, 1},
    {0x10360005, navigation, off, off, 0, 1},
    {0x50360006, navigation, 0x066251, 0x072BC8, 0, any},
    {0x10310001, receiver, on, on, 0, 1},
    {0x10310003, receiver, off, on, 0, 1},
    {0x10310007, receiver, off, on, 0, 1},
    {0x1031000A, receiver, off, on, 0, 1},
    {0x1031000D, receiver, off, on, 0, 1},
    {0x1031000E, receiver, off, on, 0, 1},
    {0x10310012, receiver, on, on, 0, 1},
    {0x10310015, receiver, off, on, 0, 1},
    {0x10310018, receiver, on, on, 0, 1},
    {0x1031001A, receiver, off, on, 0, 1},
    {0x10310005, receiver, on, on, 0, 1},
});
static_assert(items.size() == first_rate);

// In the order on the line within an epoch.
constexpr auto sent = std::to_array<MessageFacts>({
    {0xF004, 0x209100AB}, {0xF000, 0x209100BA},
    {0xF005, 0x209100B0}, {0xF002, 0x209100BF},
    {0xF003, 0x209100C4}, {0xF001, 0x209100C9},
    {0xF008, 0x209100D8}, {0x0107, 0x20910006, 1},
    {0x0103, 0x2091001A}, {0x0102, 0x20910029},
    {0x0112, 0x20910042}, {0x0106, 0},
    {0x0104, 0x20910038}, {0x0120, 0x20910047},
    {0x0121, 0x2091005B}, {0x0135, 0x20910015, 1},
    {0x0130, 0},          {0x0A09, 0x209101B4},
    {0x0A0B, 0x209101B9}, {0x0A38, 0x20910359, 0, false},
    {0x0D03, 0x20910178}, {0x0161, 0x2091015F, 1},
});

}  // namespace

std::span<const MessageFacts> message_facts() { return sent; }

namespace {

constexpr std::size_t first_inert = first_rate + ports_of_a_message * sent.size();

std::uint32_t key_of_rate(const MessageFacts& message, std::size_t port) {
  return message.key == 0 ? 0 : message.key + static_cast<std::uint32_t>(port);
}

ItemFacts facts_of_inert(std::size_t place) {
  const auto items_of_values = inert_items();
  if (place < items_of_values.size()) return items_of_values[place];
  const std::size_t rate = place - items_of_values.size();
  const std::size_t port = rate % ports_of_a_message;
  return {key_of_rate(unsent_messages()[rate / ports_of_a_message], port), messages, 0, 0, 0, 255};
}

}  // namespace

std::size_t item_count() {
  return first_inert + inert_items().size() + ports_of_a_message * unsent_messages().size();
}

ItemFacts facts_of(std::size_t item) {
  if (item < first_rate) return items[item];
  if (item >= first_inert) return facts_of_inert(item - first_inert);
  const std::size_t rate = item - first_rate, port = rate % ports_of_a_message;
  const MessageFacts& message = sent[rate / ports_of_a_message];
  const std::uint64_t delivered = port == uart1 ? message.rate : 0;
  return {key_of_rate(message, port), messages, delivered, delivered, 0, 255};
}

std::optional<std::size_t> item_of_key(std::uint32_t key) {
  for (std::size_t item = 0; key != 0 && item < item_count(); ++item)
    if (facts_of(item).key == key) return item;
  return {};
}

std::size_t size_of_key(std::uint32_t key) {
  constexpr std::array<std::size_t, 8> sizes{0, 1, 1, 2, 4, 8, 0, 0};
  return sizes[key >> 28 & 7];
}

std::optional<std::size_t> rate_item(std::uint16_t class_and_id, std::size_t port, Model model) {
  const auto in = [&](std::span<const MessageFacts> all,
                      std::size_t first) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(all, class_and_id, &MessageFacts::class_and_id);
    if (found == all.end() || !(model == Model::m8 ? found->on_m8 : found->key != 0)) return {};
    return first + static_cast<std::size_t>(found - all.begin()) * ports_of_a_message + port;
  };
  if (const auto item = in(sent, first_rate)) return item;
  return in(unsent_messages(), first_inert + inert_items().size());
}

}  // namespace drydock::emulate::ublox
