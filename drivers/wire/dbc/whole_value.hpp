#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "drivers/wire/dbc/database.hpp"
#include "drivers/wire/dbc/plan.hpp"

namespace drydock::wire::dbc {

using WholeNumber = std::variant<std::int64_t, std::uint64_t>;

/// The physical value of an integer whose factor and offset are whole, to its last digit: a double
/// has 53 bits. Empty: it may have a fraction, or needs more than 64 bits.
std::optional<WholeNumber> whole_value(const Value& value, const Layout& layout);

}  // namespace drydock::wire::dbc
