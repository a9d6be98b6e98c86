#include "drivers/wire/described/parts.hpp"

#include <cmath>

namespace drydock::wire::described {
namespace {

/// -49 and 30 are forty-nine degrees and a half, south. An integer of a binary message has no sign
/// of its own for all parts: -1 and 0.5 are a half below zero.
bool sign_is_of_all(const Field& whole) { return whole.type == Type::number; }

/// What a step of the part's number on the wire is of the whole.
double step_of(const Field& field) {
  return std::abs(field.part_of ? field.factor * field.part_factor : field.factor);
}

}  // namespace

void join_parts(Record& record) {
  if (!record.message->has_parts) return;
  const auto fields = record.plan->fields_of(*record.message);
  std::uint32_t negative = 0;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (sign_is_of_all(fields[i]) && std::signbit(record.values[i].number)) negative |= 1u << i;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i].part_of) continue;
    Value& whole = record.values[*fields[i].part_of];
    if (record.values[i].state != Value::State::number) whole.state = Value::State::none;
    const double part = record.values[i].number * fields[i].part_factor;
    whole.number += (negative >> *fields[i].part_of & 1) != 0 ? -part : part;
  }
}

double part_number(std::span<const Field> fields, const Field& field, double value) {
  const std::size_t whole = field.part_of.value_or(static_cast<std::uint8_t>(&field - &fields[0]));
  const bool apart = sign_is_of_all(fields[whole]);
  const double own = step_of(field);
  double rest = (apart ? std::abs(value) : value), above = INFINITY;
  bool is_smallest = true;
  for (double next = own; next > 0;) {
    next = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double step = step_of(fields[i]);
      if (i != whole && fields[i].part_of != whole) continue;
      if (step > own && step < above) next = std::max(next, step);
      if (step < own) is_smallest = false;
    }
    if (next > 0) rest -= std::floor(rest / next) * next;
    above = next;
  }
  const double number = is_smallest ? rest / own : std::floor(rest / own);
  return apart && !field.part_of ? std::copysign(number, value) : number;
}

}  // namespace drydock::wire::described
