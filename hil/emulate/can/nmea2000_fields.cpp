#include "drivers/wire/bytes.hpp"
#include "hil/emulate/can/nmea2000_device.hpp"

/// The fields of the PGNs about a device itself, with the values that they have now. Numbers and
/// lengths: canboat's database of PGNs; a value fills whole bytes.
namespace drydock::emulate {
namespace {

Nmea2000Field number_field(std::uint8_t number, std::uint32_t value, std::uint8_t bytes = 1) {
  Nmea2000Field field{number, bytes, {}};
  for (unsigned i = 0; i < bytes; ++i)
    field.value.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  return field;
}

std::vector<Nmea2000Field> fields_of_name(std::uint64_t value) {
  constexpr std::uint8_t reserved = 1;
  const auto name = wire::j1939::to_name(value);
  return {number_field(1, name.identity_number, 3),
          number_field(2, name.manufacturer_code, 2),
          number_field(3, name.ecu_instance),
          number_field(4, name.function_instance),
          number_field(5, name.function),
          number_field(6, reserved),
          number_field(7, name.vehicle_system),
          number_field(8, name.vehicle_system_instance),
          number_field(9, name.industry_group),
          number_field(10, name.arbitrary_address_capable ? 1 : 0)};
}

/// Fields of these lengths, one after the other.
std::vector<Nmea2000Field> cut(wire::Bytes message, std::initializer_list<std::uint8_t> lengths) {
  std::vector<Nmea2000Field> fields;
  std::size_t at = 0;
  for (const std::uint8_t length : lengths) {
    const std::size_t bytes = length == Nmea2000Field::text ? message[at] : length;
    const auto value = message.subspan(at, bytes);
    fields.push_back(
        {static_cast<std::uint8_t>(fields.size() + 1), length, {value.begin(), value.end()}});
    at += bytes;
  }
  return fields;
}

}  // namespace

std::vector<Nmea2000Field> Nmea2000Device::fields_of(std::uint32_t pgn) const {
  constexpr std::uint8_t text = Nmea2000Field::text;
  switch (pgn) {
    case wire::j1939::address_claim_pgn: return fields_of_name(settings_.in(plain_name_));
    case lists_pgn: return {number_field(1, 0)};
    case product_pgn: return cut(product_message(), {2, 2, 32, 32, 32, 32, 1, 1});
    case configuration_pgn: return cut(configuration_message(), {text, text, text});
    default: return {};
  }
}

}  // namespace drydock::emulate
