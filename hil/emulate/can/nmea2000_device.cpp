#include "hil/emulate/can/nmea2000_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drivers/wire/bytes.hpp"

namespace drydock::emulate {
namespace {

namespace j1939 = wire::j1939;

constexpr std::uint32_t acknowledgement_pgn = 59392;
constexpr std::array always_sent{acknowledgement_pgn,
                                 j1939::address_claim_pgn,
                                 wire::nmea2000::GroupFunction::pgn,
                                 lists_pgn,
                                 heartbeat_pgn,
                                 product_pgn,
                                 configuration_pgn};
constexpr std::array always_taken{j1939::request_pgn, j1939::address_claim_pgn,
                                  j1939::commanded_address_pgn, wire::nmea2000::GroupFunction::pgn};
constexpr std::uint8_t usual_priority = 6;

/// Fixed length, filled with FFh.
void put_text(std::span<std::uint8_t> field, std::string_view text) {
  std::ranges::fill(field, std::uint8_t{0xFF});
  std::ranges::copy(text.substr(0, field.size()), field.begin());
}

/// Length with these two bytes, encoding, characters.
void append_text(std::vector<std::uint8_t>& message, std::uint8_t encoding, std::string_view text) {
  message.push_back(static_cast<std::uint8_t>(text.size() + 2));
  message.push_back(encoding);
  message.insert(message.end(), text.begin(), text.end());
}

void append_pgns(std::vector<std::uint8_t>& message, std::span<const std::uint32_t> pgns) {
  for (const std::uint32_t pgn : pgns)
    for (unsigned i = 0; i < 3; ++i) message.push_back(static_cast<std::uint8_t>(pgn >> 8 * i));
}

}  // namespace

void Nmea2000Device::hear(const wire::CanFrame& frame, Stamp now, std::uint8_t address, Wire& out) {
  const auto id = j1939::identify(frame);
  if (id && id->pgn == wire::nmea2000::GroupFunction::pgn)
    return hear_group_function(*id, frame.payload(), now, address, out);
  const auto request = id ? j1939::decode_request(*id, frame.payload()) : std::nullopt;
  if (!request) return hear_message(frame, now, out);
  if (request->destination == j1939::global_address || request->destination == address)
    answer(*request, address, out);
}

bool Nmea2000Device::knows(std::uint32_t pgn) const {
  return std::ranges::find(always_sent, pgn) != always_sent.end() ||
         std::ranges::find(product_.sends, pgn) != product_.sends.end();
}

void Nmea2000Device::answer(const j1939::Request& request, std::uint8_t address, Wire& out) {
  const bool to_all = request.destination == j1939::global_address;
  const std::uint8_t asker = to_all ? j1939::global_address : request.source;
  switch (request.pgn) {
    case j1939::address_claim_pgn: return;  // the node has answered
    case product_pgn: return tell_product(address, out);
    case configuration_pgn: return tell_configuration(address, out);
    case heartbeat_pgn: return send_heartbeat(address, out);
    case lists_pgn: return tell_lists({usual_priority, lists_pgn, asker, address}, {}, out);
    default: break;
  }
  if (to_all || std::ranges::find(product_.sends, request.pgn) != product_.sends.end()) return;
  constexpr std::uint8_t negative = 1;
  wire::CanFrame frame =
      j1939::blank_frame({usual_priority, acknowledgement_pgn, request.source, address});
  frame.data[0] = negative;
  for (unsigned i = 0; i < 3; ++i)
    frame.data[5 + i] = static_cast<std::uint8_t>(request.pgn >> 8 * i);
  out.send(frame);
}

std::vector<std::uint8_t> Nmea2000Device::product_message() const {
  constexpr std::uint16_t version_2_100 = 2100, no_product = 0xFFFF;
  constexpr std::size_t texts = 4, text_size = 32;
  constexpr std::uint8_t not_certified = 0xFF, load_50_ma = 1;
  std::vector<std::uint8_t> message(4 + text_size * texts + 2);
  wire::store_le<std::uint16_t>(message, 0, version_2_100);
  wire::store_le<std::uint16_t>(message, 2, no_product);
  const std::string serial = fmt::format("{}", serial_number_);
  const std::array<std::string_view, texts> all{product_.model, "emulated", "1", serial};
  for (std::size_t i = 0; i < texts; ++i)
    put_text(std::span(message).subspan(4 + text_size * i, text_size), all.at(i));
  message[message.size() - 2] = not_certified;
  message[message.size() - 1] = load_50_ma;
  return message;
}

std::vector<std::uint8_t> Nmea2000Device::configuration_message() const {
  constexpr std::uint8_t ascii = 1;
  std::vector<std::uint8_t> message;
  for (const auto& text : settings_.descriptions) append_text(message, text.encoding, text.bytes);
  append_text(message, ascii, "emulated by Drydock");
  return message;
}

void Nmea2000Device::tell_product(std::uint8_t address, Wire& out) {
  send_packet({usual_priority, product_pgn, j1939::global_address, address}, told_++,
              product_message(), out);
}

void Nmea2000Device::tell_configuration(std::uint8_t address, Wire& out) {
  send_packet({usual_priority, configuration_pgn, j1939::global_address, address}, told_++,
              configuration_message(), out);
}

void Nmea2000Device::tell_lists(const j1939::Identifier& id, std::optional<std::uint8_t> which,
                                Wire& out) {
  constexpr std::uint8_t sent = 0, taken = 1;
  if (which.value_or(sent) == sent) {
    std::vector<std::uint8_t> message{sent};
    append_pgns(message, always_sent);
    append_pgns(message, product_.sends);
    send_packet(id, told_++, message, out);
  }
  if (which.value_or(taken) == taken) {
    std::vector<std::uint8_t> message{taken};
    append_pgns(message, always_taken);
    append_pgns(message, product_.takes);
    send_packet(id, told_++, message, out);
  }
}

}  // namespace drydock::emulate
