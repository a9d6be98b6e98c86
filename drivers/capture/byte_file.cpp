#include "drivers/capture/byte_file.hpp"

#include <algorithm>

namespace drydock::capture {

std::size_t ByteFile::read(std::span<std::uint8_t> into) {
  std::size_t filled = 0;
  while (filled < into.size()) {
    while (rest_.empty()) {
      const wire::Bytes block = blocks_.read();
      if (block.empty()) return filled;
      rest_ = content_.of(block);
    }
    const auto piece = rest_.first(std::min(rest_.size(), into.size() - filled));
    std::ranges::copy(piece, into.begin() + static_cast<std::ptrdiff_t>(filled));
    filled += piece.size();
    rest_ = rest_.subspan(piece.size());
  }
  return filled;
}

}  // namespace drydock::capture
