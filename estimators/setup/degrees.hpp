#pragma once

#include <numbers>

namespace drydock::setup {

constexpr double to_deg = 180 / std::numbers::pi;  ///< for what people read

}  // namespace drydock::setup
