#pragma once

#include <numbers>

namespace drydock::setup {

constexpr double to_deg = 180 / std::numbers::pi;  ///< for printed output

}  // namespace drydock::setup
