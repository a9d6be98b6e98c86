#include "hil/campaign/runs/one_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/printable.hpp"
#include "hil/campaign/plan/figure_path.hpp"
#include "hil/campaign/plan/placeholders.hpp"
#include "hil/campaign/runs/child_process.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string run_text(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The lines that say something. The run's folder has another name each time, so it becomes its
/// placeholder.
std::vector<std::string> lines_of(const fs::path& path) {
  const std::string folder = path.parent_path().string();
  std::istringstream text(run_text(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    for (auto at = line.find(folder); at != std::string::npos; at = line.find(folder))
      line.replace(at, folder.size(), "{folder}");
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      lines.push_back(text::printable(line));
  }
  return lines;
}

/// Why a program ended. Some say it first and add how to get help, others say it last, below where
/// it happened: the first line, the last one, and what is between if it is short. At most this
/// long: a journal is no place for a core dump.
std::string its_words(const fs::path& errors, const fs::path& output) {
  constexpr std::size_t longest = 300, few = 3;
  auto lines = lines_of(errors);
  if (lines.empty()) lines = lines_of(output);
  if (lines.empty()) return "it printed nothing";
  if (lines.size() > few) lines = {lines.front(), "...", lines.back()};
  for (auto& line : lines)
    if (line.size() > longest / few) line = line.substr(0, longest / few) + "...";
  return text::printable(fmt::format("{}", fmt::join(lines, " / ")));
}

/// `drydock` is this program, wherever it is installed.
std::vector<std::string> runnable(std::vector<std::string> words) {
  if (words.front() == "drydock") words.front() = "/proc/self/exe";
  return words;
}

std::string failure_of(const ChildEnd& end, const Child& child) {
  if (end.how == Ended::by_timeout) return fmt::format("took longer than {} s", child.timeout_s);
  if (end.how == Ended::by_signal) return fmt::format("ended by signal {}", end.code);
  if (end.code == terminal::exit_success || end.code == terminal::exit_failed) return {};
  return fmt::format("exit code {}: {}", end.code, its_words(child.errors, child.output));
}

/// Adds the figures, or says in `failure` what is missing.
void take_figures(const CampaignConfig& campaign, const fs::path& json, const Child& child,
                  Record& record) {
  const Json document = Json::parse(run_text(json), nullptr, false);
  record.figures.assign(campaign.figures.size(), std::nullopt);
  if (!record.failure.empty()) return;
  if (document.is_discarded()) {
    record.failure = fmt::format("no JSON came, exit code {}: {}", record.exit_code,
                                 its_words(child.errors, child.output));
    return;
  }
  for (std::size_t i = 0; i < campaign.figures.size(); ++i)
    record.figures[i] = figure_at(document, campaign.figures[i].at);
  if (std::ranges::none_of(record.figures, [](const auto& f) { return f.has_value(); }))
    record.failure = "none of the figures is in its JSON";
}

/// Whether its figures come in a file: the command names it, or a script of the campaign.
bool writes_json(const CampaignConfig& campaign) {
  const auto names_it = [](const std::string& text) { return text.find("{json}") != text.npos; };
  return names_it(campaign.command) ||
         std::ranges::any_of(campaign.files, names_it, &FileConfig::text);
}

std::int64_t now_ms() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

}  // namespace

std::optional<Record> do_run(const CampaignConfig& campaign, std::size_t index,
                             const fs::path& folder, const std::function<bool()>& stopped) {
  const auto begin = std::chrono::steady_clock::now();
  for (const auto& file : campaign.files)
    report::write_file(folder / file.name, filled(campaign, index, folder, file.text));
  const Child child{.words = runnable(command_of(campaign, index, folder)),
                    .output = folder / "output.txt",
                    .errors = folder / "errors.txt",
                    .timeout_s = campaign.timeout_s};
  const ChildEnd end = run_child(child, stopped);
  if (end.how == Ended::from_outside) return std::nullopt;
  Record record{.index = index, .figures = {}, .exit_code = end.code};
  record.failure = failure_of(end, child);
  take_figures(campaign, writes_json(campaign) ? json_file(folder) : child.output, child, record);
  record.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record.ended_ms = now_ms();
  return record;
}

}  // namespace drydock::campaign
