#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace drydock::emulate {

/// Object 1003h: the errors that a node has had, the last one first.
class CanopenErrors {
 public:
  static constexpr std::size_t most = 8;

  void add(std::uint16_t code) {
    std::shift_right(codes_.begin(), codes_.end(), 1);
    codes_[0] = code;
    count_ = std::min(count_ + 1, most);
  }
  void clear() { count_ = 0; }
  std::size_t count() const { return count_; }
  std::uint32_t operator[](std::size_t error) const { return codes_[error]; }

 private:
  std::array<std::uint32_t, most> codes_{};
  std::size_t count_ = 0;
};

}  // namespace drydock::emulate
