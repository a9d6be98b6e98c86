#include "hil/summary/write_files.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <stdexcept>

#include "hil/report/write_file.hpp"
#include "hil/summary/junit.hpp"

namespace drydock::summary {

void write_files(const Summary& summary, const SummaryFiles& files, const std::string& rig_file) {
  std::string errors;
  const auto write = [&](const std::filesystem::path& path, const std::string& text) {
    try {
      report::write_file(path, text);
      return true;
    } catch (const std::exception& error) {
      errors += (errors.empty() ? "" : "\n") + std::string(error.what());
      return false;
    }
  };
  if (!files.json.empty()) write(files.json, to_json(summary));
  if (!files.junit.empty()) write(files.junit, to_junit(summary, rig_file));
  const auto page = std::filesystem::path(files.report) / "index.html";
  if (!files.report.empty() && write(page, to_html(summary)))
    fmt::print("report: {}\n", page.string());
  if (!errors.empty()) throw std::runtime_error(errors);
}

}  // namespace drydock::summary
