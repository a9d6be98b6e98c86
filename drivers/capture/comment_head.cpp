#include "drivers/capture/comment_head.hpp"

#include <algorithm>
#include <optional>

#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

constexpr std::string_view blanks = " \t";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_sign(std::string_view text) { return text == "-" || text == "+"; }

/// The text behind the number with which it begins; itself if it begins with none.
std::string_view behind_number(std::string_view text) {
  std::size_t i = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t digits = i;
  while (i < text.size() && (is_digit(text[i]) || text[i] == '.')) ++i;
  return i > digits ? text.substr(i) : text;
}

std::string_view behind_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(blanks), text.size()));
}

/// PuTTY's line above each session that it logs: `=~=~=~=~= PuTTY log 2024.05.01 12:00:00 =~=~`.
constexpr std::string_view putty_begin = "=~=~=~=~";

/// Whether the line that begins so is a comment. Empty: more of it must come.
std::optional<bool> is_comment(std::string_view line) {
  if (line.starts_with(putty_begin)) return true;
  if (putty_begin.starts_with(line)) return {};
  if (line[0] != '#') return false;
  if (line.size() == 1) return {};
  constexpr std::string_view ends_hash = " \t\r\n";
  if (ends_hash.find(line[1]) == ends_hash.npos) return false;
  const std::string_view text = behind_blanks(line.substr(1));
  const std::string_view rest = behind_number(text);
  if (rest.empty() || is_sign(text)) return {};
  if (rest.size() == text.size()) return true;
  if (rest[0] == ',' || rest[0] == ';') return false;
  if (blanks.find(rest[0]) == blanks.npos) return true;
  const std::string_view second = behind_blanks(rest);
  if (second.empty() || is_sign(second)) return {};
  return behind_number(second).size() == second.size();
}

}  // namespace

wire::Bytes CommentHead::without(wire::Bytes block) {
  if (at_ == At::data || block.empty()) return block;
  if (!held_.empty()) {
    held_.insert(held_.end(), block.begin(), block.end());
    joined_ = std::move(held_);
    held_.clear();
    block = joined_;
  }
  while (!block.empty()) {
    if (at_ == At::line_start) {
      const auto comment = is_comment(wire::as_text(block));
      if (!comment) {
        held_.assign(block.begin(), block.end());
        return {};
      }
      at_ = *comment ? At::comment : At::data;
    }
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
