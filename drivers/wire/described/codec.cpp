#include "drivers/wire/described/codec.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/wire/described/parts.hpp"

namespace drydock::wire::described {
namespace {

Decoded decode_frames(const Plan& plan, Bytes frame, Record& record) {
  for (const Message& message : plan.messages) {
    if (!has_head(message, frame)) continue;
    record.begin(plan, message);
    if (decode_binary(plan, message, frame, record)) return Decoded::message;
  }
  return Decoded::other;
}

}  // namespace

Scan scan(const Plan& plan, Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  std::size_t start = 0;
  while (start < bytes.size() && !plan.starts[bytes[start]]) ++start;
  if (start > 0) return Scan::skip(start);
  switch (plan.form) {
    case Form::sentences: return scan_sentence(plan, bytes);
    case Form::binary: return scan_binary(plan, bytes);
    case Form::lines:
    case Form::frames: break;
  }
  return scan_line(plan, bytes);
}

Decoded decode(const Plan& plan, Bytes frame, Record& record) {
  if (plan.stuffing != Stuffing::none) {
    Packet packet;
    return unstuff(plan.stuffing, frame, packet) ? decode_frames(plan, packet, record)
                                                 : Decoded::misfit;
  }
  return plan.form == Form::binary ? decode_frames(plan, frame, record)
                                   : decode_texts(plan, frame, record);
}

std::size_t encode(const Plan& plan, const Message& message, const Readings& readings,
                   std::span<std::uint8_t> out) {
  return plan.form == Form::binary ? encode_binary(plan, message, readings, out)
                                   : encode_text(plan, message, readings, out);
}

bool has_head(const Message& message, Bytes bytes) {
  const std::string& head = message.head;
  if (bytes.size() < head.size()) return false;
  for (std::size_t i = head.size(); i-- > 0;) {  // sentences differ at the end of their heads
    const bool talker = message.any_talker && (i == 1 || i == 2);
    if (talker ? !is_talker(bytes[i]) : bytes[i] != static_cast<std::uint8_t>(head[i]))
      return false;
  }
  return true;
}

void take_validity(const Field& field, const Value& raw, std::string_view text, Record& record) {
  const Validity& rule = *field.validity;
  bool good = std::ranges::find(rule.good_texts, text) != rule.good_texts.end();
  if (raw.state == Value::State::number) {
    good = good || std::ranges::find(rule.good_numbers, raw.number) != rule.good_numbers.end();
    good = good || (rule.above && raw.number > *rule.above);
  }
  record.valid = record.valid && good;
}

void divide(Record& record) {
  if (!record.message->divides) return;
  const auto fields = record.plan->fields_of(*record.message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i].divisor) continue;
    Value& value = record.values[i];
    const Value& by = record.values[*fields[i].divisor];
    if (value.state != Value::State::number) continue;
    const bool may = by.state == Value::State::number && by.number > 0;
    value.number = may ? value.number / by.number : 0;
    if (!may || !std::isfinite(value.number)) value.state = Value::State::none;
  }
}

void apply_signs(Record& record) {
  if (!record.message->has_signs) return;
  const auto fields = record.plan->fields_of(*record.message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type != Type::sign) continue;
    const std::string_view sign = record.values[i].text;
    Value& value = record.values[fields[i].sign_of];
    if (value.state != Value::State::number) continue;
    if (sign == fields[i].minus)
      value.number = -value.number;
    else if (sign != fields[i].text)
      value.state = Value::State::none;
  }
}

std::optional<double> wire_number(std::span<const Field> fields, const Field& field,
                                  const Readings& readings) {
  if (field.validity)
    return measures_nothing(fields, readings) ? field.validity->bad_number : field.idle;
  const auto target = field.part_of ? fields[*field.part_of].target : field.target;
  if (!target) return field.idle;
  std::optional<double> value = readings.get(*target);
  if (value && field.divisor) {
    const auto by = readings.get(*fields[*field.divisor].target);
    value = by ? std::optional(*value * *by) : std::nullopt;
  }
  if (value && (field.has_parts || field.part_of))
    value = part_number(fields, field, *value);
  else if (value)
    value = (*value - field.offset) / field.factor;
  if (value && std::isfinite(*value)) return value;
  return field.no_value.empty() ? std::nullopt : std::optional(field.no_value.front());
}

double within_turn(const Field& field, double number, double low, double high) {
  if (!field.target || !is_circular(*field.target)) return number;
  const double turn = 2 * std::numbers::pi / std::abs(field.factor);
  if (number > high && number - turn >= low) return number - turn;
  return number < low && number + turn <= high ? number + turn : number;
}

bool measures_nothing(std::span<const Field> fields, const Readings& readings) {
  bool measures = false;
  for (const Field& field : fields) {
    if (!field.target || is_time(*field.target) || *field.target == Target::utc) continue;
    measures = true;  // but a receiver without a fix may know the time
    if (readings.has(*field.target)) return false;
  }
  return measures || !readings.measured();
}

bool says_nothing_holds(std::span<const Field> fields, const Readings& readings) {
  return measures_nothing(fields, readings) &&
         std::ranges::any_of(fields, [](const Field& field) { return field.validity.has_value(); });
}

}  // namespace drydock::wire::described
