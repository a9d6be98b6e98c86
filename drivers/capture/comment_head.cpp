#include "drivers/capture/comment_head.hpp"

#include <algorithm>

namespace drydock::capture {

wire::Bytes CommentHead::without(wire::Bytes block) {
  while (at_ != At::data && !block.empty()) {
    if (at_ == At::line_start) {
      at_ = block.front() == '#' ? At::comment : At::data;
      continue;
    }
    const auto end = std::find(block.begin(), block.end(), '\n');
    if (end == block.end()) return {};
    at_ = At::line_start;
    block = block.subspan(static_cast<std::size_t>(end - block.begin()) + 1);
  }
  return block;
}

}  // namespace drydock::capture
