#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// SAE J1939 and NMEA 2000 addressing: 29-bit identifiers (J1939-21), device NAMEs, address claim
/// and request messages (J1939-81). j1939_address_claim.hpp has the claim procedure.
namespace drydock::wire::j1939 {

constexpr std::uint8_t global_address = 0xFF;
constexpr std::uint8_t null_address = 0xFE;  ///< address of a node that could not claim one
constexpr std::uint32_t request_pgn = 59904;
constexpr std::uint32_t address_claim_pgn = 60928;
constexpr std::uint32_t commanded_address_pgn = 65240;

/// priority<<26 | PGN<<8 | source. If the PDU format is below 240, the PGN's low byte is the
/// destination.
struct Identifier {
  std::uint8_t priority = 6;  ///< 0 wins the bus, 7 yields
  std::uint32_t pgn = 0;
  std::uint8_t destination = global_address;
  std::uint8_t source = null_address;
  friend bool operator==(const Identifier&, const Identifier&) = default;
};

constexpr bool is_addressed(std::uint32_t pgn) { return ((pgn >> 8) & 0xFF) < 240; }

constexpr Identifier parse_identifier(std::uint32_t id) {
  Identifier parsed{static_cast<std::uint8_t>((id >> 26) & 7), (id >> 8) & 0x3FFFF, global_address,
                    static_cast<std::uint8_t>(id & 0xFF)};
  if (is_addressed(parsed.pgn)) {
    parsed.destination = static_cast<std::uint8_t>(parsed.pgn & 0xFF);
    parsed.pgn &= 0x3FF00;
  }
  return parsed;
}

constexpr std::uint32_t make_identifier(const Identifier& id) {
  const std::uint32_t pgn = is_addressed(id.pgn) ? (id.pgn & 0x3FF00) | id.destination : id.pgn;
  return std::uint32_t{id.priority} << 26 | (pgn & 0x3FFFF) << 8 | id.source;
}

/// Empty for frames that cannot be J1939: 11-bit, remote, error and CAN FD frames.
inline std::optional<Identifier> identify(const CanFrame& frame) {
  if (!frame.extended || frame.remote || frame.error || frame.fd) return std::nullopt;
  return parse_identifier(frame.id);
}

/// An extended data frame of 8 bytes, all 0xFF ("not available").
CanFrame blank_frame(const Identifier& id);

/// The 64-bit NAME of a device, SAE layout: identity number in the lowest bits.
struct Name {
  std::uint32_t identity_number = 0;         ///< 21 bits: serial number
  std::uint16_t manufacturer_code = 0;       ///< 11 bits
  std::uint8_t ecu_instance = 0;             ///< 3 bits
  std::uint8_t function_instance = 0;        ///< 5 bits
  std::uint8_t function = 0;                 ///< 8 bits
  std::uint8_t vehicle_system = 0;           ///< 7 bits; NMEA 2000: device class
  std::uint8_t vehicle_system_instance = 0;  ///< 4 bits
  std::uint8_t industry_group = 0;           ///< 3 bits, 4 = marine
  bool arbitrary_address_capable = false;    ///< may move to another address
  friend bool operator==(const Name&, const Name&) = default;
};

std::uint64_t to_value(const Name& name);
Name to_name(std::uint64_t value);

/// PGN 60928. From the null address it means "cannot claim an address".
struct AddressClaimed {
  static constexpr std::string_view type = "address_claimed";
  std::uint8_t source = null_address;
  std::uint64_t name = 0;  ///< the number compared in contention: the lowest wins
};

/// PGN 59904: asks one node, or all, to send a PGN.
struct Request {
  static constexpr std::string_view type = "request";
  std::uint8_t source = null_address;
  std::uint8_t destination = global_address;
  std::uint32_t pgn = 0;
};

/// PGN 65240, through the transport protocol: the node with this NAME must claim this address.
struct CommandedAddress {
  static constexpr std::string_view type = "commanded_address";
  static constexpr std::size_t bytes = 9;
  std::uint8_t source = null_address;
  std::uint64_t name = 0;
  std::uint8_t address = null_address;
};

std::optional<AddressClaimed> decode_address_claimed(const Identifier& id, Bytes payload);
std::optional<Request> decode_request(const Identifier& id, Bytes payload);
std::optional<CommandedAddress> decode_commanded_address(const Identifier& id, Bytes message);
CanFrame encode(const AddressClaimed& claim);
CanFrame encode(const Request& request);
std::array<std::uint8_t, CommandedAddress::bytes> encode(const CommandedAddress& command);

template <class Field>
void visit_fields(const Name& n, Field&& field) {
  field("identity_number", n.identity_number);
  field("manufacturer_code", n.manufacturer_code);
  field("ecu_instance", n.ecu_instance);
  field("function_instance", n.function_instance);
  field("function", n.function);
  field("vehicle_system", n.vehicle_system);
  field("vehicle_system_instance", n.vehicle_system_instance);
  field("industry_group", n.industry_group);
  field("arbitrary_address_capable", n.arbitrary_address_capable);
}

template <class Field>
void visit_fields(const AddressClaimed& m, Field&& field) {
  field("source", m.source);
  visit_fields(to_name(m.name), field);
}

template <class Field>
void visit_fields(const Request& m, Field&& field) {
  field("source", m.source);
  field("destination", m.destination);
  field("requested_pgn", m.pgn);
}

template <class Field>
void visit_fields(const CommandedAddress& m, Field&& field) {
  field("source", m.source);
  field("new_address", m.address);
  visit_fields(to_name(m.name), field);
}

}  // namespace drydock::wire::j1939
