#pragma once

#include <array>
#include <string_view>

#include "drivers/wire/described/plan.hpp"
#include "drivers/wire/fields.hpp"

namespace drydock::wire::described {

struct Value {
  enum class State : std::uint8_t { none, number, text, malformed };
  State state = State::none;
  double number = 0;        ///< SI with a target, else in the unit of the wire
  std::string_view text{};  ///< within the frame
};

/// The values of one message, one for each of its fields. It refers to the plan and to the frame.
struct Record {
  std::string_view type{};  ///< the message's name
  const Plan* plan = nullptr;
  const Message* message = nullptr;
  std::array<Value, most_fields> values;
  bool valid = true;       ///< as the message says
  unsigned malformed = 0;  ///< fields that were no numbers; they read as empty
  unsigned present = 0;    ///< frames, and messages of records: fields that this one has

  void begin(const Plan& of, const Message& one) {
    type = one.name;
    plan = &of;
    message = &one;
    valid = true;
    malformed = 0;
    present = 0;
  }
};

/// Values of the targets. Without validity there are only the times.
inline void read(const Record& record, Readings& readings) {
  readings.clear();
  const auto fields = record.plan->fields_of(*record.message);
  for (const std::uint8_t i : record.message->mapped) {
    const Value& value = record.values[i];
    if (value.state != Value::State::number || readings.has(*fields[i].target)) continue;
    readings.set(*fields[i].target, value.number);
  }
  if (!record.valid) readings.keep_times();
}

/// False for a message of records in which no record came that has a part of the measurement.
inline bool measures(const Record& record) {
  const auto fields = record.plan->fields_of(*record.message);
  return !record.message->records ||
         std::ranges::any_of(record.message->mapped, [&](std::uint8_t i) {
           return !is_time(*fields[i].target) &&
                  (!fields[i].record || (record.present >> i & 1) != 0);
         });
}

template <class F>
void visit_fields(const Record& record, F&& field) {
  const auto fields = record.plan->fields_of(*record.message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].key.empty()) continue;
    const Value& value = record.values[i];
    if (fields[i].type == Type::text) {
      field(fields[i].key, value.text);
      continue;
    }
    std::optional<double> number;
    if (value.state == Value::State::number) number = value.number;
    const double unit = fields[i].target ? row_of(*fields[i].target).shown : 1;
    field(fields[i].key, unit == 1 ? number : degrees(number));
  }
}

}  // namespace drydock::wire::described
