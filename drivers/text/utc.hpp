#pragma once

#include <optional>
#include <string_view>

#include "drivers/measurement/stamp.hpp"

namespace drydock::text {

/// "2023-11-14T22:13:20Z", with or without a fraction of up to nine digits. Empty if the text is no
/// such time.
std::optional<measurement::Stamp> parse_utc(std::string_view text);

}  // namespace drydock::text
