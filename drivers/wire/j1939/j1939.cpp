#include "drivers/wire/j1939/j1939.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::j1939 {

CanFrame blank_frame(const Identifier& id) {
  CanFrame frame;
  frame.id = make_identifier(id);
  frame.extended = true;
  frame.size = 8;
  std::fill_n(frame.data.begin(), 8, std::uint8_t{0xFF});
  return frame;
}

std::uint64_t to_value(const Name& n) {
  return std::uint64_t{n.identity_number & 0x1FFFFF} |
         std::uint64_t{n.manufacturer_code & 0x7FFu} << 21 |
         std::uint64_t{n.ecu_instance & 0x7u} << 32 |
         std::uint64_t{n.function_instance & 0x1Fu} << 35 | std::uint64_t{n.function} << 40 |
         std::uint64_t{n.vehicle_system & 0x7Fu} << 49 |
         std::uint64_t{n.vehicle_system_instance & 0xFu} << 56 |
         std::uint64_t{n.industry_group & 0x7u} << 60 |
         std::uint64_t{n.arbitrary_address_capable} << 63;
}

Name to_name(std::uint64_t value) {
  Name n;
  n.identity_number = value & 0x1FFFFF;
  n.manufacturer_code = value >> 21 & 0x7FF;
  n.ecu_instance = value >> 32 & 0x7;
  n.function_instance = value >> 35 & 0x1F;
  n.function = value >> 40 & 0xFF;
  n.vehicle_system = value >> 49 & 0x7F;
  n.vehicle_system_instance = value >> 56 & 0xF;
  n.industry_group = value >> 60 & 0x7;
  n.arbitrary_address_capable = value >> 63 != 0;
  return n;
}

std::optional<AddressClaimed> decode_address_claimed(const Identifier& id, Bytes payload) {
  if (id.pgn != address_claim_pgn || payload.size() < 8) return std::nullopt;
  return AddressClaimed{id.source, load_le<std::uint64_t>(payload, 0)};
}

std::optional<Request> decode_request(const Identifier& id, Bytes payload) {
  if (id.pgn != request_pgn || payload.size() < 3) return std::nullopt;
  const std::uint32_t pgn = payload[0] | payload[1] << 8 | payload[2] << 16;
  return Request{id.source, id.destination, pgn};
}

std::optional<CommandedAddress> decode_commanded_address(const Identifier& id, Bytes message) {
  if (id.pgn != commanded_address_pgn || message.size() < CommandedAddress::bytes) {
    return std::nullopt;
  }
  return CommandedAddress{id.source, load_le<std::uint64_t>(message, 0), message[8]};
}

std::array<std::uint8_t, CommandedAddress::bytes> encode(const CommandedAddress& command) {
  std::array<std::uint8_t, CommandedAddress::bytes> message;
  store_le<std::uint64_t>(message, 0, command.name);
  message[8] = command.address;
  return message;
}

CanFrame encode(const AddressClaimed& claim) {
  CanFrame frame = blank_frame({6, address_claim_pgn, global_address, claim.source});
  store_le<std::uint64_t>(frame.data, 0, claim.name);
  return frame;
}

CanFrame encode(const Request& request) {
  CanFrame frame = blank_frame({6, request_pgn, request.destination, request.source});
  frame.size = 3;
  for (unsigned i = 0; i < 3; ++i) frame.data[i] = request.pgn >> 8 * i & 0xFF;
  return frame;
}

}  // namespace drydock::wire::j1939
