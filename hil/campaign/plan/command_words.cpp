#include "hil/campaign/plan/command_words.hpp"

#include <cctype>
#include <utility>

namespace drydock::campaign {

std::optional<std::vector<std::string>> command_words(std::string_view command) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = 0;
  for (const char c : command) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (quote == 0 && blank) {
      if (word) words.push_back(*std::exchange(word, {}));
      continue;
    }
    if (!word) word.emplace();
    if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else if (c == quote)
      quote = 0;
    else
      *word += c;
  }
  if (quote != 0) return {};
  if (word) words.push_back(std::move(*word));
  return words;
}

}  // namespace drydock::campaign
