#pragma once

#include <optional>
#include <string_view>

#include "drivers/measurement/stamp.hpp"

namespace drydock::score {

/// Decimal seconds since 1970, to the nearest nanosecond: a double has only about 200 ns there. An
/// exponent is read too: numpy.savetxt writes 1.7e+09.
std::optional<measurement::Stamp> stamp_of_seconds(std::string_view text);
/// A whole number of nanoseconds since 1970, perhaps with an exponent; empty if it has a fraction.
std::optional<measurement::Stamp> stamp_of_nanoseconds(std::string_view text);
/// The same of another unit: 10 to the power of `digits` nanoseconds, to the nearest nanosecond.
std::optional<measurement::Stamp> stamp_of_decimal(std::string_view text, int digits);
/// A time without a unit: as UTC ("2026-11-21 08:00:00.125", with T, Z and a fraction or without),
/// or a number, of which the size tells seconds, milli-, micro- or nanoseconds since 1970. What is
/// too small for a date is of seconds.
std::optional<measurement::Stamp> stamp_of_any(std::string_view text);
std::optional<double> number_of(std::string_view text);

}  // namespace drydock::score
