#pragma once

#include "drivers/wire/described/record.hpp"

/// A value that a message says in several fields: seconds and nanoseconds, degrees and minutes.
namespace drydock::wire::described {

/// Adds each part to the field that it belongs to. Without one of its parts that one has no value.
void join_parts(Record& record);

/// The number on the wire of a field that has parts, or is one, of a value in SI units: the part
/// that no larger one says. Whole numbers, but of the smallest part.
double part_number(std::span<const Field> fields, const Field& field, double value);

}  // namespace drydock::wire::described
