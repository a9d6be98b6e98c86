#include "hil/emulate/can/nmea2000_pairs.hpp"

#include <algorithm>

#include "drivers/wire/nmea2000/group_function.hpp"

namespace drydock::emulate {
namespace {

using Answer = wire::nmea2000::GroupAcknowledgement;

std::size_t length_of(const Nmea2000Field& field, wire::Bytes value) {
  if (field.bytes != Nmea2000Field::text) return field.bytes;
  constexpr std::size_t shortest_text = 2;
  return value.empty() ? shortest_text : std::max<std::size_t>(value[0], shortest_text);
}

}  // namespace

Nmea2000Pairs pairs_in(wire::Bytes bytes, std::size_t count,
                       const std::vector<Nmea2000Field>& fields) {
  Nmea2000Pairs pairs;
  std::uint8_t code = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Nmea2000Pair pair;
    if (code == 0) {
      pairs.cut_short = bytes.empty();
      pair.number = bytes.empty() ? std::uint8_t{} : bytes[0];
      const auto field = std::ranges::find(fields, pair.number, &Nmea2000Field::number);
      if (!bytes.empty()) bytes = bytes.subspan(1);
      const std::size_t length = field == fields.end() ? 0 : length_of(*field, bytes);
      pairs.cut_short = pairs.cut_short || bytes.size() < length;
      if (field == fields.end() || pairs.cut_short) {
        pair.code = Answer::parameter_invalid;
        code = Answer::parameter_not_now;
      } else {
        pair.value = bytes.first(length);
        bytes = bytes.subspan(length);
      }
    } else {
      pair.code = code;
    }
    pairs.all.push_back(pair);
  }
  return pairs;
}

void compare(Nmea2000Pairs& pairs, const std::vector<Nmea2000Field>& fields) {
  for (Nmea2000Pair& pair : pairs.all) {
    const auto field = std::ranges::find(fields, pair.number, &Nmea2000Field::number);
    if (pair.code == 0 && !std::ranges::equal(pair.value, field->value))
      pair.code = Answer::parameter_out_of_range;
  }
}

}  // namespace drydock::emulate
