#include "hil/fault/wire/damage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

std::size_t below(std::size_t bound, RandomStream& random) {
  return static_cast<std::size_t>(random.next() % bound);
}

void flip_bit_within(std::span<std::uint8_t> bytes, RandomStream& random) {
  if (bytes.empty()) return;
  const std::size_t bit = below(bytes.size() * 8, random);
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1u << bit % 8));
}

using rig_config::FaultKind;

constexpr Damage all_damages[] = {
    {FaultKind::flip, flip_bit, flip_bit},
    {FaultKind::flip_header, flip_header_bit, nullptr},
    {FaultKind::truncate, truncate, truncate},
    {FaultKind::bad_checksum, [](Message& message, RandomStream&) { break_checksum(message); },
     nullptr},
};

/// MessageFaults carries out the words that lose, add or move whole messages.
constexpr FaultKind of_whole_messages[] = {FaultKind::drop, FaultKind::duplicate,
                                           FaultKind::reorder, FaultKind::garbage};

consteval bool each_message_fault_is_carried_out() {
  return std::ranges::all_of(rig_config::fault_vocabulary(), [](const auto& word) {
    return word.layer != rig_config::FaultLayer::message ||
           std::ranges::find(all_damages, word.kind, &Damage::kind) != std::end(all_damages) ||
           std::ranges::find(of_whole_messages, word.kind) != std::end(of_whole_messages);
  });
}
static_assert(each_message_fault_is_carried_out(),
              "a message fault of the vocabulary does nothing");

}  // namespace

std::span<const Damage> damages() { return all_damages; }

void flip_bit(Message& message, RandomStream& random) { flip_bit_within(message, random); }

void flip_header_bit(Message& message, RandomStream& random) {
  flip_bit_within(std::span(message).first(std::min(message.size(), header_bytes)), random);
}

void flip_bit(wire::CanFrame& frame, RandomStream& random) {
  if (frame.size == 0) return;
  const std::size_t bit = below(frame.size * std::size_t{8}, random);
  auto& byte = frame.data.at(bit / 8);
  byte = static_cast<std::uint8_t>(byte ^ (1u << bit % 8));
}

void truncate(Message& message, RandomStream& random) {
  if (!message.empty()) message.resize(below(message.size(), random));
}

void truncate(wire::CanFrame& frame, RandomStream& random) {
  if (frame.size > 0) frame.size = static_cast<std::uint8_t>(below(frame.size, random));
}

void break_checksum(Message& message) {
  if (message.empty()) return;
  const auto star = std::find(message.rbegin(), message.rend(), '*');
  const auto behind = star - message.rbegin();  // two digits, then at most an end of line
  if (behind >= 2 && behind <= 4) {
    auto& digit = *(star - 1);
    digit = digit == '0' ? '1' : '0';
  } else {
    message.back() ^= 0xFF;
  }
}

Message garbage(std::size_t bytes, RandomStream& random) {
  Message noise(bytes);
  for (auto& byte : noise) byte = static_cast<std::uint8_t>(random.next());
  return noise;
}

wire::CanFrame garbage_frame(std::size_t bytes, RandomStream& random) {
  constexpr std::uint32_t extended_identifiers = 1u << 29;
  wire::CanFrame frame;
  frame.id = static_cast<std::uint32_t>(random.next() % extended_identifiers);
  frame.extended = true;
  frame.size = static_cast<std::uint8_t>(std::min<std::size_t>(bytes, 8));
  for (std::size_t i = 0; i < frame.size; ++i)
    frame.data.at(i) = static_cast<std::uint8_t>(random.next());
  return frame;
}

}  // namespace drydock::fault
