#include "drivers/capture/comment_head.hpp"

#include <algorithm>
#include <string_view>

namespace drydock::capture {

wire::Bytes CommentHead::without(wire::Bytes block) {
  if (at_ == At::data || block.empty()) return block;
  if (at_ == At::hash) {
    joined_.assign(1, '#');
    joined_.insert(joined_.end(), block.begin(), block.end());
    block = joined_;
    at_ = At::line_start;
  }
  while (!block.empty()) {
    if (at_ == At::line_start) {
      const bool alone = block.size() == 1 && block[0] == '#';
      constexpr std::string_view ends_hash = " \t\r\n";
      const bool comment = !alone && block[0] == '#' &&
                           ends_hash.find(static_cast<char>(block[1])) != ends_hash.npos;
      at_ = alone ? At::hash : comment ? At::comment : At::data;
    }
    if (at_ == At::hash) return {};
    if (at_ == At::data) return block;
    const auto end = std::find(block.begin(), block.end(), '\n');
    const auto line = static_cast<std::size_t>(end - block.begin()) + (end != block.end());
    if (end != block.end()) at_ = At::line_start;
    size_ += line;
    block = block.subspan(line);
  }
  return block;
}

}  // namespace drydock::capture
