#include "drivers/capture/byte_file.hpp"

#include <algorithm>

namespace drydock::capture {

std::size_t ByteFile::read(std::span<std::uint8_t> into) {
  std::size_t filled = 0;
  while (filled < into.size()) {
    if (rest_.empty()) {
      const auto read = line_.next();
      if (!read) return filled;
      rest_ = read->bytes;
      continue;  // a packet may be empty
    }
    const auto piece = rest_.first(std::min(rest_.size(), into.size() - filled));
    std::ranges::copy(piece, into.begin() + static_cast<std::ptrdiff_t>(filled));
    filled += piece.size();
    rest_ = rest_.subspan(piece.size());
  }
  return filled;
}

}  // namespace drydock::capture
