#pragma once

#include <cmath>
#include <functional>

#include "drivers/wire/described/record.hpp"

/// The codec of every described protocol, by the contract of drivers/wire/codec.hpp. The plan is
/// the argument that other codecs do not need.
namespace drydock::wire::described {

Scan scan(const Plan& plan, Bytes bytes);

enum class Decoded : std::uint8_t {
  message,
  other,  ///< a valid frame that the description does not name
  misfit  ///< it names the frame, but the content has another form
};

/// Decodes a frame of scan(). `record` holds a message only after Decoded::message.
Decoded decode(const Plan& plan, Bytes frame, Record& record);

/// Writes a message for an emulated device. A target without a value is written as the
/// description's first `no_value`, as an empty text, or as 0 beside a field that says `bad`.
/// Returns the bytes written; 0: it does not fit into `out`, or its form has no way to say that
/// there is no value.
std::size_t encode(const Plan& plan, const Message& message, const Readings& readings,
                   std::span<std::uint8_t> out);

/// For a framer: scan() with its plan.
struct Scanner {
  const Plan* plan = nullptr;
  Scan operator()(Bytes bytes) const { return scan(*plan, bytes); }
};

// The parts for each form of protocol.
Scan scan_sentence(const Plan& plan, Bytes bytes);
Scan scan_binary(const Plan& plan, Bytes bytes);
Scan scan_line(const Plan& plan, Bytes bytes);

/// True if the bytes begin with this head.
bool has_head(const Message& message, Bytes bytes);

/// The first message whose head, constants and number of fields are those of a sentence or line.
Decoded decode_texts(const Plan& plan, Bytes frame, Record& record);
bool decode_binary(const Plan& plan, const Message& message, Bytes frame, Record& record);
/// Tells the identifier of each record of a frame of scan() that its message does not describe.
void unread_records(const Plan& plan, Bytes frame,
                    const std::function<void(std::uint16_t)>& unread);

/// What both have in common: a number of the wire becomes the field's value.
inline void take_number(const Field& field, double number, Value& value) {
  for (const double none : field.no_value)
    if (none == number) return;
  value.number = number * field.factor;
  if (!field.has_parts) value.number += field.offset;  // -0 degrees and 30 minutes are south
  value.state = std::isfinite(value.number) ? Value::State::number : Value::State::malformed;
}
void take_validity(const Field& field, const Value& raw, std::string_view text, Record& record);
/// Divides the fields that are a distance in a time.
void divide(Record& record);
/// Gives fields the signs that stand apart. One without its sign has no value.
void apply_signs(Record& record);

/// The number that a field has on the wire; empty: there is no value.
std::optional<double> wire_number(std::span<const Field> fields, const Field& field,
                                  const Readings& readings);
/// The same angle as `low` to `high` can say it: 340 degrees are -20 in a signed number.
double within_turn(const Field& field, double number, double low, double high);
/// True if nothing that the message measures has a value now. A message that only says whether
/// others hold looks at the whole sample.
bool measures_nothing(std::span<const Field> fields, const Readings& readings);
/// True if that is so, and the message can say it: its values then mean nothing.
bool says_nothing_holds(std::span<const Field> fields, const Readings& readings);
std::size_t encode_text(const Plan& plan, const Message& message, const Readings& readings,
                        std::span<std::uint8_t> out);
std::size_t encode_binary(const Plan& plan, const Message& message, const Readings& readings,
                          std::span<std::uint8_t> out);

}  // namespace drydock::wire::described
