#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace drydock::device {

/// Text of at most `Capacity` characters, kept in place; what does not fit is cut off.
template <std::size_t Capacity>
class FixedText {
 public:
  static constexpr std::size_t capacity = Capacity;

  FixedText() = default;
  FixedText(std::string_view text) { *this += text; }

  FixedText& operator+=(std::string_view text) {
    const std::size_t n = std::min(text.size(), Capacity - size_);
    std::copy_n(text.begin(), n, chars_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += n;
    return *this;
  }

  std::string_view view() const { return {chars_.data(), size_}; }
  bool empty() const { return size_ == 0; }

 private:
  std::array<char, Capacity> chars_{};
  std::size_t size_ = 0;
};

using Reason = FixedText<160>;

}  // namespace drydock::device
