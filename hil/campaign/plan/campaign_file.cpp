#include "hil/campaign/plan/campaign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "hil/campaign/plan/command_words.hpp"
#include "hil/campaign/plan/placeholders.hpp"
#include "hil/campaign/plan/read_parameter.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/rules/schema_check.hpp"
#include "rig_config/toml/checked_file.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/toml/toml_reader.hpp"

namespace drydock::campaign {
namespace {

using rig_config::Node;
using rig_config::Problems;

void read_head(const Node& table, CampaignConfig& campaign) {
  read(table, "name", campaign.name);
  read(table, "command", campaign.command);
  if (const Node* seed = table.find("seed"))
    campaign.seed = static_cast<std::uint64_t>(seed->integer);
  if (const Node* runs = table.find("repetitions"))
    campaign.repetitions = static_cast<std::size_t>(runs->integer);
  read(table, "timeout_s", campaign.timeout_s);
  read(table, "confidence", campaign.confidence);
}

FigureConfig read_figure(const Node& table) {
  constexpr std::array betters{"less", "more", "near_zero"};
  FigureConfig figure{.name = table.find("name")->text, .at = table.find("at")->text};
  if (table.find("better")) figure.better = rig_config::named<Better>(table, betters, "better");
  read(table, "same_within", figure.same_within);
  return figure;
}

/// Capitals or not, as a data base compares the names of columns.
bool are_one_name(const std::string& a, const std::string& b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Columns of the results and placeholders share one set of names.
void check_names(const Node& root, const std::string& path, Problems& problems) {
  std::vector<std::string> seen{"index",  "repetition", "seed",   "json",
                                "folder", "exit_code",  "failure"};
  for (const char* list : {"parameter", "figure"})
    rig_config::for_each_table(root, list, [&](const Node& table, std::size_t i) {
      const Node& name = *table.find("name");
      const auto taken = std::ranges::find_if(
          seen, [&](const std::string& other) { return are_one_name(other, name.text); });
      if (taken != seen.end())
        problems.push_back({path, name.at.line, name.at.column, fmt::format("/{}/{}/name", list, i),
                            fmt::format("the name '{}' is taken", *taken)});
      seen.push_back(name.text);
    });
}

/// JSON and a set of words in braces have quotes, blanks or commas between them.
bool is_a_name(std::string_view text) {
  return text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_:.-") ==
             std::string_view::npos &&
         !text.empty();
}

void check_command(const Node& root, const CampaignConfig& campaign, const std::string& path,
                   Problems& problems) {
  const Node& command = *root.find("campaign")->find("command");
  if (!command_words(campaign.command))
    problems.push_back(
        {path, command.at.line, command.at.column, "/campaign/command", "a quote is not closed"});
  for (const auto& name : unknown_placeholders(campaign, campaign.command)) {
    const bool own = !is_a_name(name) || campaign.command.find("${" + name) != std::string::npos;
    if (own) continue;
    problems.push_back({path, command.at.line, command.at.column, "/campaign/command",
                        fmt::format("there is no '{{{}}}', allowed: {}", name,
                                    fmt::join(placeholder_names(campaign), ", "))});
  }
}

/// In a file most braces are its own: of TOML, of a shell (${x}), of a script. So only a name that
/// looks like a misspelt placeholder is one. Short names look like each other.
void check_files(const Node& root, const CampaignConfig& campaign, const std::string& path,
                 Problems& problems) {
  const auto names = placeholder_names(campaign);
  rig_config::for_each_table(root, "file", [&](const Node& table, std::size_t i) {
    const Node& text = *table.find("text");
    constexpr std::size_t shortest = 3;
    for (const auto& name : unknown_placeholders(campaign, text.text)) {
      const bool own = name.size() < shortest || text.text.find("${" + name) != std::string::npos;
      if (const auto meant = rig_config::did_you_mean(name, names); !own && !meant.empty())
        problems.push_back({path, text.at.line, text.at.column, fmt::format("/file/{}/text", i),
                            fmt::format("there is no '{{{}}}'{}", name, meant)});
    }
  });
}

/// Before anything multiplies: the product of many lists has more digits than an index.
void check_runs(const CampaignConfig& campaign, const std::string& path, Problems& problems) {
  constexpr double most = 1e9;
  auto runs = static_cast<double>(campaign.repetitions);
  for (const auto& parameter : campaign.parameters)
    if (parameter.draw == Draw::list) runs *= static_cast<double>(parameter.list.size());
  if (runs > most)
    problems.push_back(
        {path, 1, 1, "/", fmt::format("{:.3g} are more runs than {:.0f}", runs, most)});
}

}  // namespace

rig_config::Loaded<CampaignConfig> load_campaign_text(std::string_view text,
                                                      const std::string& path) {
  const auto root = rig_config::read_toml(text, path);
  if (!root) return root.error();
  Problems problems = rig_config::check_schema(*root, path, campaign_schema_text());
  if (!problems.empty()) return problems;
  CampaignConfig campaign{.text = std::string(text)};
  read_head(*root->find("campaign"), campaign);
  rig_config::for_each_table(*root, "parameter", [&](const Node& table, std::size_t) {
    campaign.parameters.push_back(read_parameter(table, path, problems));
  });
  rig_config::for_each_table(*root, "figure", [&](const Node& table, std::size_t) {
    campaign.figures.push_back(read_figure(table));
  });
  rig_config::for_each_table(*root, "file", [&](const Node& table, std::size_t) {
    campaign.files.push_back({table.find("name")->text, table.find("text")->text});
  });
  check_names(*root, path, problems);
  check_command(*root, campaign, path, problems);
  check_files(*root, campaign, path, problems);
  check_runs(campaign, path, problems);
  if (!problems.empty()) return problems;
  return campaign;
}

rig_config::Loaded<CampaignConfig> load_campaign(const std::string& path) {
  const auto text = rig_config::read_file(path);
  if (!text) return text.error();
  return load_campaign_text(*text, path);
}

}  // namespace drydock::campaign
