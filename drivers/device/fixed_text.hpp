#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace drydock::device {

/// Text of at most `Capacity` characters, stored in place; longer text is cut off. Control
/// characters become '?', because people read the text on terminals and sensors may have written
/// it.
template <std::size_t Capacity>
class FixedText {
 public:
  static constexpr std::size_t capacity = Capacity;

  FixedText() = default;
  FixedText(std::string_view text) { *this += text; }

  FixedText& operator+=(std::string_view text) {
    const std::size_t n = std::min(text.size(), Capacity - size_);
    std::transform(text.begin(), text.begin() + n, chars_.begin() + size_, [](char c) {
      const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
      return control ? '?' : c;
    });
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
