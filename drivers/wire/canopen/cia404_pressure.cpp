#include "drivers/wire/canopen/cia404_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace cia404_pressure {

namespace {

constexpr std::uint32_t tpdo1_base = canopen::tpdo_id(1, 0);

std::optional<ProcessValue> decode_value(std::uint8_t node, const CanFrame& frame) {
  if (frame.size != 4 && frame.size != 5 && frame.size != 8) return std::nullopt;
  ProcessValue value;
  value.node = node;
  std::copy_n(frame.data.begin(), value.raw.size(), value.raw.begin());
  if (frame.size == 5) value.status = frame.data[4];
  return value;
}

double steps_per_unit(const Scale& scale) { return std::pow(10.0, scale.decimals); }

/// The integer and its status.
std::pair<std::int32_t, std::uint8_t> quantized(const std::optional<double>& number) {
  constexpr auto lowest = std::numeric_limits<std::int32_t>::min();
  constexpr auto highest = std::numeric_limits<std::int32_t>::max();
  if (!number || !std::isfinite(*number)) return {0, status::not_valid};
  const double rounded = std::round(*number);
  if (rounded > highest) return {highest, status::not_valid | status::positive_overload};
  if (rounded < lowest) return {lowest, status::not_valid | status::negative_overload};
  return {static_cast<std::int32_t>(rounded), 0};
}

}  // namespace

std::int32_t as_integer(const ProcessValue& value) { return load_le<std::int32_t>(value.raw, 0); }

std::optional<double> as_real(const ProcessValue& value) {
  const auto number = load_le<float>(value.raw, 0);
  if (!std::isfinite(number)) return std::nullopt;
  return number;
}

const Unit* find_unit(std::string_view name) {
  const auto* const found = std::ranges::find(units, name, &Unit::name);
  return found == units.end() ? nullptr : found;
}

std::optional<Scale> find_scale(std::string_view form, std::string_view unit, unsigned decimals) {
  constexpr std::array<std::string_view, 3> forms{"integer+status", "integer", "real32"};
  const auto* const found = std::ranges::find(forms, form);
  const Unit* const found_unit = find_unit(unit);
  if (found == forms.end() || !found_unit) return std::nullopt;
  return Scale{static_cast<Form>(found - forms.begin()), *found_unit, decimals};
}

std::optional<double> pressure_pa(const ProcessValue& value, const Scale& scale) {
  if (value.status.value_or(0) != 0) return std::nullopt;
  const auto number = scale.form == Form::real32
                          ? as_real(value)
                          : std::optional{as_integer(value) / steps_per_unit(scale)};
  if (!number) return std::nullopt;
  return *number * scale.unit.pascals;
}

CanFrame encode(std::uint8_t node, const std::optional<double>& pressure_pa, const Scale& scale) {
  CanFrame frame;
  frame.id = canopen::tpdo_id(1, node);
  frame.size = scale.form == Form::integer_and_status ? 5 : 4;
  if (scale.form == Form::real32) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    store_le<float>(frame.data, 0,
                    static_cast<float>(pressure_pa.value_or(nan) / scale.unit.pascals));
    return frame;
  }
  std::optional<double> number = pressure_pa;
  if (number) *number = *number / scale.unit.pascals * steps_per_unit(scale);
  const auto [integer, state] = quantized(number);
  store_le<std::int32_t>(frame.data, 0, integer);
  frame.data[4] = scale.form == Form::integer_and_status ? state : 0;
  return frame;
}

}  // namespace cia404_pressure

std::optional<Cia404Pressure::Message> Cia404Pressure::Decoder::receive(const CanFrame& frame) {
  std::optional<Message> message;
  if (const auto node = canopen::node_above(frame, cia404_pressure::tpdo1_base)) {
    if (const auto value = cia404_pressure::decode_value(*node, frame)) message = *value;
    return count_frame(counters_, frame, message);
  }
  if (const auto heartbeat = canopen::decode_heartbeat(frame)) message = *heartbeat;
  if (const auto emergency = canopen::decode_emergency(frame)) message = *emergency;
  if (!message) return std::nullopt;
  return count_frame(counters_, frame, message);
}

}  // namespace drydock::wire
