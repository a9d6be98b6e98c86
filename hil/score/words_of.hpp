#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::score {

/// The words of a line, with blanks, tabs, commas or semicolons between them; `#` begins a comment.
inline std::vector<std::string> words_of(std::string_view line) {
  std::string text(line.substr(0, line.find('#')));
  std::ranges::replace_if(
      text, [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream in(std::move(text));
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace drydock::score
