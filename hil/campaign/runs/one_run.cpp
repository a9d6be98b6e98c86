#include "hil/campaign/runs/one_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/terminal/exit_codes.hpp"
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

/// The last line that says something, at most this long: a journal is no place for a core dump.
/// The run's folder has another name each time, so it becomes its placeholder.
std::string last_words(const fs::path& path) {
  constexpr std::size_t longest = 300;
  std::string text = run_text(path);
  text.erase(text.find_last_not_of(" \n") + 1);
  text.erase(0, text.rfind('\n') + 1);  // npos + 1 is 0
  const std::string folder = path.parent_path().string();
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.replace(at, folder.size(), "{folder}");
  return text.substr(0, longest);
}

/// `drydock` is this program, wherever it is installed.
std::vector<std::string> runnable(std::vector<std::string> words) {
  if (words.front() == "drydock") words.front() = "/proc/self/exe";
  return words;
}

std::string failure_of(const ChildEnd& end, double timeout_s, const fs::path& errors) {
  if (end.how == Ended::by_timeout) return fmt::format("took longer than {} s", timeout_s);
  if (end.how == Ended::by_signal) return fmt::format("ended by signal {}", end.code);
  if (end.code == terminal::exit_success || end.code == terminal::exit_failed) return {};
  return fmt::format("exit code {}: {}", end.code, last_words(errors));
}

/// Adds the figures, or says in `failure` what is missing.
void take_figures(const CampaignConfig& campaign, const fs::path& json, const fs::path& errors,
                  Record& record) {
  const Json document = Json::parse(run_text(json), nullptr, false);
  record.figures.assign(campaign.figures.size(), std::nullopt);
  if (!record.failure.empty()) return;
  if (document.is_discarded()) {
    record.failure =
        fmt::format("no JSON came, exit code {}: {}", record.exit_code, last_words(errors));
    return;
  }
  for (std::size_t i = 0; i < campaign.figures.size(); ++i)
    record.figures[i] = figure_at(document, campaign.figures[i].at);
  if (std::ranges::none_of(record.figures, [](const auto& f) { return f.has_value(); }))
    record.failure = "none of the figures is in its JSON";
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
  record.failure = failure_of(end, campaign.timeout_s, child.errors);
  const bool to_file = campaign.command.find("{json}") != std::string::npos;
  take_figures(campaign, to_file ? json_file(folder) : child.output, child.errors, record);
  record.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  record.ended_ms = now_ms();
  return record;
}

}  // namespace drydock::campaign
