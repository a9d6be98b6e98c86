#pragma once

#include <charconv>
#include <chrono>

#include "drivers/device/fixed_text.hpp"

namespace drydock::device {

/// A duration for a person, to the nearest 10 ms: "2 s", "0.25 s".
inline FixedText<24> in_words(std::chrono::nanoseconds duration) {
  const auto centiseconds =
      std::chrono::round<std::chrono::duration<long long, std::centi>>(duration).count();
  std::array<char, 24> digits{};
  const double s = static_cast<double>(centiseconds) / 100.0;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), s).ptr;
  FixedText<24> text = std::string_view(digits.data(), end);
  text += " s";
  return text;
}

}  // namespace drydock::device
