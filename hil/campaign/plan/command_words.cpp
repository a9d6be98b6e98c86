#include "hil/campaign/plan/command_words.hpp"

#include <algorithm>

namespace drydock::campaign {

std::optional<std::vector<std::string>> command_words(std::string_view command) {
  constexpr std::string_view blanks = " \t\r\n";
  std::vector<std::string> words;
  while (true) {
    const auto begin = command.find_first_not_of(blanks);
    if (begin == command.npos) return words;
    command.remove_prefix(begin);
    std::string word;
    if (const char quote = command.front(); quote == '\'' || quote == '"') {
      const auto end = command.find(quote, 1);
      if (end == command.npos) return {};
      word = command.substr(1, end - 1);
      command.remove_prefix(end + 1);
    }
    const auto end = std::min(command.find_first_of(blanks), command.size());
    word += command.substr(0, end);
    command.remove_prefix(end);
    words.push_back(std::move(word));
  }
}

}  // namespace drydock::campaign
