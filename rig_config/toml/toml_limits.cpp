#include "rig_config/toml/toml_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::rig_config {

namespace {

constexpr int deepest_brackets = 32, most_key_parts = 16;

/// Scans a text. Of TOML it knows only strings, comments and the rest.
class DepthScan {
 public:
  DepthScan(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  std::optional<Problem> run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
        continue;
      }
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      note(c);
      if (brackets_ > deepest_brackets)
        return problem(fmt::format("more than {} brackets in brackets", deepest_brackets));
      if (dots_ >= most_key_parts)
        return problem(fmt::format("a key of more than {} parts", most_key_parts));
      ++at_;
    }
    return {};
  }

 private:
  void note(char c) {
    if (c == '[' || c == '{') ++brackets_;
    if ((c == ']' || c == '}') && brackets_ > 0) --brackets_;
    if (c == '.')
      ++dots_;
    else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{')
      dots_ = 0;
    if (c == '\n') ++line_;
  }

  /// Moves behind the closing quotes. A string without closing quotes ends with its line.
  void skip_string(char quote) {
    const bool long_one = text_.substr(at_, 3) == std::string(3, quote);
    at_ += long_one ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!long_one) return;
        ++line_;
      }
      if (c == '\\' && quote == '"') {
        ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++line_;
      } else if (c == quote && (!long_one || text_.substr(at_, 3) == std::string(3, quote))) {
        at_ += long_one ? 3 : 1;
        // A long string may end with up to two quotes before its three closing quotes.
        for (int more = 0; long_one && more < 2 && at_ < text_.size() && text_[at_] == quote;
             ++more)
          ++at_;
        return;
      }
      ++at_;
    }
  }

  Problem problem(std::string what) const { return {path_, line_, 1, "/", std::move(what)}; }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1, brackets_ = 0, dots_ = 0;
};

}  // namespace

std::optional<Problem> beyond_limits(std::string_view text, const std::string& path) {
  if (text.size() > largest_file)
    return Problem{path, 0, 0, "/",
                   fmt::format("has {} bytes, allowed: up to {}", text.size(), largest_file)};
  return DepthScan(text, path).run();
}

}  // namespace drydock::rig_config
