#include "hil/campaign/report/repeat.hpp"

#include <fmt/format.h>

#include "hil/campaign/plan/placeholders.hpp"

namespace drydock::campaign {

std::string shell_word(const std::string& word) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string repeat_command(const CampaignConfig& campaign, const std::string& path,
                           std::size_t index) {
  if (!campaign.files.empty())
    return fmt::format("drydock campaign {} --only {}", shell_word(path), index);
  std::string line;
  for (const auto& word : command_of(campaign, index, "."))
    line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

}  // namespace drydock::campaign
