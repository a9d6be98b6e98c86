#include "rig_config/device_description/page_framing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Form;
using described::Message;
using described::Plan;

std::string hex_of(std::string_view bytes) {
  std::string text;
  for (const char c : bytes)
    text += fmt::format("{}{:02X}", text.empty() ? "" : " ", static_cast<unsigned char>(c));
  return text;
}

std::string_view first(bool big_endian) { return big_endian ? "high" : "low"; }

/// Of the checksum of a binary frame.
std::string binary_checksum(const Plan& plan) {
  std::string text = fmt::format("Checksum: {}, {} byte{}", plan.checksum.name(),
                                 plan.checksum.size(), plan.checksum.size() == 1 ? "" : "s");
  if (plan.checksum.size() > 1)
    text += fmt::format(", {} byte first", first(plan.checksum_big_endian));
  if (plan.checksum_at)
    return text + fmt::format(", at byte {}, of the bytes from {} to the end.\n", *plan.checksum_at,
                              plan.checksum_from);
  return text + fmt::format(", of the bytes from {} up to it.\n", plan.checksum_from);
}

std::string text_checksum(const Plan& plan) {
  return fmt::format(
      "Checksum: {}, {} hexadecimal digits behind `*`, of the characters from {}{}.\n",
      plan.checksum.name(), plan.checksum_digits(), plan.checksum_from,
      plan.checksum_optional ? "; a sentence without it counts too" : "");
}

std::string header_checksum(const described::HeaderChecksum& header) {
  return fmt::format("Checksum of the header: {}, at byte {}, of the bytes {} to {}.\n",
                     header.checksum.name(), header.at, header.from, header.to - 1);
}

std::string_view name_of(described::Stuffing stuffing) {
  constexpr std::array<std::string_view, 5> names{"none", "dle", "slip", "hdlc", "cobs"};
  return names.at(static_cast<std::size_t>(stuffing));
}

std::string length_of(const described::Length& length) {
  if (length.is_any()) return "Length: as its delimiters say.\n";
  if (length.size == 0) return fmt::format("Length: {} bytes.\n", length.fixed);
  std::string text = fmt::format("Length: the u{} at byte {}", 8 * length.size, length.at);
  if (length.size > 1) text += fmt::format(", {} byte first", first(length.big_endian));
  return text +
         (length.plus > 0 ? fmt::format(", plus {} bytes.\n", length.plus) : ", in bytes.\n");
}

/// SAE J1939-21: below 240 in its second byte the low byte of a group is the destination.
std::uint32_t group_of(std::uint32_t id) {
  constexpr std::uint32_t group_bits = 0x3FFFF, first_broadcast = 240;
  const std::uint32_t group = id >> 8 & group_bits;
  return (group >> 8 & 0xFF) < first_broadcast ? group & ~std::uint32_t{0xFF} : group;
}

std::string identifier_of(const wire::dbc::Message& message) {
  std::string id = fmt::format("Identifier {:X}h, {} bits", message.id, message.extended ? 29 : 11);
  if (message.format != wire::dbc::FrameFormat::j1939) return id;
  const std::uint32_t source = message.id & 0xFF;
  const std::string sender = source == wire::dbc::any_source ? std::string("any sender")
                                                             : fmt::format("sender {}", source);
  return fmt::format("{}: J1939, PGN {} of {}", id, group_of(message.id), sender);
}

std::string protection_of(const wire::dbc::Protection& protection) {
  using wire::dbc::Checksum;
  std::string text =
      fmt::format("Checksum: {} in byte {}", to_string(protection.checksum), protection.at);
  if (protection.checksum == Checksum::e2e_2)
    text += fmt::format(", identifiers {:02X}", fmt::join(protection.data_ids, " "));
  else if (protection.checksum <= Checksum::e2e_5)
    text += fmt::format(", identifier {:04X}h", protection.data_id);
  else if (protection.seed != 0)
    text += fmt::format(", seed {:02X}h", protection.seed);
  return text + ".\n";
}

}  // namespace

std::string readable(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte > 0x20 && byte < 0x7F && byte != '|' ? std::string(1, c)
                                                      : fmt::format("\\x{:02X}", byte);
  }
  return text;
}

std::string protocol_framing(const Plan& plan) {
  std::string text;
  if (plan.checksum.size() != 0)
    text += plan.form == Form::binary ? binary_checksum(plan) : text_checksum(plan);
  if (plan.header) text += header_checksum(*plan.header);
  if (plan.stuffing != described::Stuffing::none)
    text += fmt::format("Stuffing: {}; places count in the packet without it.\n",
                        name_of(plan.stuffing));
  if (!plan.end.empty()) text += fmt::format("Each frame ends with {}.\n", hex_of(plan.end));
  return text;
}

std::string message_framing(const Plan& plan, const Message& message) {
  std::string text;
  if (!message.head.empty())
    text = fmt::format("Begins with `{}`.\n",
                       plan.form == Form::binary ? hex_of(message.head) : readable(message.head));
  if (plan.form == Form::binary) text += length_of(message.length);
  if (!message.extra.empty())
    text += fmt::format("Its checksum takes in {} behind it.\n", hex_of(message.extra));
  return text;
}

std::string frame_framing(const described::FrameLayout& frame) {
  std::string text = fmt::format("{}, {} bytes", identifier_of(frame.message), frame.message.size);
  if (frame.message.cycle_ms != 0) text += fmt::format(", each {} ms", frame.message.cycle_ms);
  text += ".\n";
  if (frame.counter)
    text +=
        fmt::format("Counter: signal {}, modulo {}.\n",
                    frame.message.signals[frame.counter->signal].long_name, frame.counter->modulus);
  if (frame.checksum) text += protection_of(*frame.checksum);
  return text;
}

}  // namespace drydock::rig_config
