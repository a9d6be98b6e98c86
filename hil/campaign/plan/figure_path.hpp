#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace drydock::campaign {

/// The number at a path such as /devices/dvl/rate_hz. In an array a step is an index from 0, the
/// `name` of an element, or # for their number, which is the last step. True is 1, false 0. Empty:
/// nothing is there, or no number.
std::optional<double> figure_at(const nlohmann::json& document, std::string_view path);

}  // namespace drydock::campaign
