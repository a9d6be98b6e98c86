#include "hil/campaign/plan/placeholders.hpp"

#include <algorithm>
#include <functional>

#include "hil/campaign/plan/command_words.hpp"

namespace drydock::campaign {
namespace {

/// Replaces {name} by `value(name)`; keeps it where that gives null.
std::string replaced(std::string_view text,
                     const std::function<const std::string*(std::string_view)>& value) {
  std::string out;
  while (!text.empty()) {
    const auto open = text.find('{');
    out += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const auto close = text.find_first_of("{}", open + 1);
    const bool pair = close != std::string_view::npos && text[close] == '}';
    const std::string* found = pair ? value(text.substr(open + 1, close - open - 1)) : nullptr;
    out += found ? std::string_view(*found) : text.substr(open, 1);
    text.remove_prefix(found ? close + 1 : open + 1);
  }
  return out;
}

std::vector<std::string> placeholder_values(const CampaignConfig& campaign, std::size_t index,
                                            const std::filesystem::path& folder) {
  const Plan plan(campaign);
  std::vector<std::string> values{std::to_string(index), std::to_string(plan.repetition_of(index)),
                                  std::to_string(plan.seed_of(index)), json_file(folder).string(),
                                  folder.string()};
  for (const auto& value : plan.values_of(index)) values.push_back(to_text(value));
  for (const auto& file : campaign.files) values.push_back((folder / file.name).string());
  return values;
}

}  // namespace

std::vector<std::string> placeholder_names(const CampaignConfig& campaign) {
  std::vector<std::string> names{"index", "repetition", "seed", "json", "folder"};
  for (const auto& parameter : campaign.parameters) names.push_back(parameter.name);
  for (const auto& file : campaign.files) names.push_back("file:" + file.name);
  return names;
}

std::vector<std::string> unknown_placeholders(const CampaignConfig& campaign,
                                              std::string_view text) {
  const auto names = placeholder_names(campaign);
  std::vector<std::string> unknown;
  replaced(text, [&](std::string_view name) -> const std::string* {
    if (std::ranges::find(names, name) == names.end()) unknown.emplace_back(name);
    return nullptr;
  });
  return unknown;
}

std::string filled(const CampaignConfig& campaign, std::size_t index,
                   const std::filesystem::path& folder, std::string_view text) {
  const auto names = placeholder_names(campaign);
  const auto values = placeholder_values(campaign, index, folder);
  return replaced(text, [&](std::string_view name) -> const std::string* {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? nullptr
                                : &values[static_cast<std::size_t>(found - names.begin())];
  });
}

std::vector<std::string> command_of(const CampaignConfig& campaign, std::size_t index,
                                    const std::filesystem::path& folder) {
  auto words = command_words(campaign.command).value();
  for (auto& word : words) word = filled(campaign, index, folder, word);
  return words;
}

}  // namespace drydock::campaign
