#include "hil/study/run/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/report/table.hpp"
#include "hil/study/run/study_page.hpp"
#include "hil/study/run/study_progress.hpp"
#include "hil/study/run/study_timing.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::study {
namespace {

namespace fs = std::filesystem;

constexpr int study_failed = 1, study_usage = 2;

/// A result file. It is opened before the work, so that a wrong path is found early.
class Output {
 public:
  explicit Output(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;  // the stream below reports a missing folder
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), ignored);
    stream_.open(path_);
  }
  bool write(const std::string& text) {
    stream_ << text;
    return good();
  }
  bool good() {
    if (stream_.flush()) return true;
    trouble_ = std::strerror(errno);
    return false;
  }
  const std::string& trouble() const { return trouble_; }  ///< of the write that failed last
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  std::ofstream stream_;
  std::string trouble_;
};

std::string to_json(const study::Study& study, const study::Options& options,
                    const study::Result& result) {
  nlohmann::ordered_json json;
  json["study"] = {{"name", study.name},
                   {"seed", options.seed},
                   {"runs", options.runs},
                   {"runs_done", result.runs}};
  json.update(result.json);
  return text::json_of_any_text(json) + "\n";
}

}  // namespace

std::optional<std::string> unknown_case(const study::Study& study,
                                        const std::vector<std::string>& asked) {
  if (asked.empty()) return {};
  if (!study.cases) return "has no cases to choose from";
  const auto known = study.cases();
  for (const auto& name : asked)
    if (std::ranges::find(known, name) == known.end())
      return fmt::format("case '{}' is not known, allowed: {}", name, fmt::join(known, ", "));
  return {};
}

std::string study_names() {
  std::string names;
  for (const auto& study : study::studies())
    names += (names.empty() ? "" : ", ") + std::string(study.name);
  return names;
}

int run_study(const StudyOptions& options, std::FILE* out, std::FILE* errors) {
  const auto all = study::studies();
  const auto found = std::ranges::find(all, options.name, &study::Study::name);
  if (found != all.end()) return run_study(*found, options, out, errors);
  std::vector<std::string> names;
  for (const auto& study : all) names.emplace_back(study.name);
  fmt::print(errors, "study: '{}' is not known{}, allowed: {}\n", options.name,
             rig_config::did_you_mean(options.name, names), study_names());
  return study_usage;
}

int run_study(const study::Study& study, const StudyOptions& options, std::FILE* out,
              std::FILE* errors) {
  if (const auto wrong = unknown_case(study, options.campaign.cases)) {
    fmt::print(errors, "study {}: {}\n", study.name, *wrong);
    return study_usage;
  }
  const auto cannot_write = [&](const Output& file) {
    fmt::print(errors, "study: {}: cannot be written: {}\n", file.path().string(), file.trouble());
    return study_failed;
  };
  std::optional<Output> json, report;
  if (!options.json.empty() && !json.emplace(options.json).good()) return cannot_write(*json);
  if (!options.report.empty() && !report.emplace(fs::path(options.report) / "index.html").good())
    return cannot_write(*report);

  study::Options campaign = options.campaign;
  if (campaign.jobs == 0) campaign.jobs = std::max(1U, std::thread::hardware_concurrency());
  StudyProgress progress(errors);
  auto result = study.run(campaign, progress);
  progress.finish(study.name, result.runs, campaign);

  if (result.runs == 0) return study_failed;
  if (study.workloads) add_step_times(study.workloads(), result);
  for (const auto& table : result.tables) fmt::print(out, "{}\n", report::to_text(table));
  if (json && !json->write(to_json(study, campaign, result))) return cannot_write(*json);
  if (report && !report->write(page_of(study, campaign, result))) return cannot_write(*report);
  return result.runs == campaign.runs ? 0 : study_failed;
}

}  // namespace drydock::study
