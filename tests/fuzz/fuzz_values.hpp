#pragma once

#include <cmath>
#include <concepts>
#include <cstdlib>
#include <ranges>
#include <string_view>

namespace drydock::wire::fuzz {

/// A field may be empty, but a codec never returns NaN or infinity as a value.
template <class Value>
void require_finite(const Value& value) {
  if constexpr (std::floating_point<Value>) {
    if (!std::isfinite(value)) std::abort();
  } else if constexpr (requires { value.has_value(); }) {
    if (value.has_value()) require_finite(*value);
  } else if constexpr (std::ranges::range<Value>) {
    for (const auto& element : value) require_finite(element);
  } else if constexpr (requires { visit_fields(value, [](std::string_view, const auto&) {}); }) {
    visit_fields(value, [](std::string_view, const auto& member) { require_finite(member); });
  }
}

}  // namespace drydock::wire::fuzz
