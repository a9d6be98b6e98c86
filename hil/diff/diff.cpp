#include "hil/diff/diff.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <vector>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/diff/diff_output.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::diff {

namespace {

bool is_interrupted(const Side& side) { return side.curves && side.curves->interrupted; }

/// Both sides. Empty after Ctrl-C.
std::vector<Side> read_sides(const DiffOptions& options) {
  std::vector<Side> sides;
  for (const auto& file : {options.a, options.b}) {
    sides.push_back(read_side(file));
    if (is_interrupted(sides.back())) return {};
  }
  return sides;
}

int write_report(const std::string& folder, const std::string& html, std::FILE* err) {
  const auto page = std::filesystem::path(folder) / "index.html";
  try {
    report::write_file(page, html);
  } catch (const std::exception& error) {
    fmt::print(err, "diff: {}\n", error.what());
    return terminal::exit_failed;
  }
  fmt::print(err, "report: {}\n", page.string());
  return terminal::exit_success;
}

}  // namespace

int diff(const DiffOptions& options, std::FILE* out, std::FILE* err) {
  std::vector<Side> sides;
  try {
    sides = read_sides(options);
  } catch (const std::exception& error) {
    fmt::print(err, "diff: {}\n", error.what());
    return terminal::exit_failed;
  }
  if (sides.empty()) return terminal::exit_interrupted;
  const auto& a = sides.front();
  const auto& b = sides.back();
  const auto comparison = compare(a.summary, b.summary, options.tolerance);
  fmt::print(out, "{}", options.json ? to_json(a, b, comparison) : to_text(a, b, comparison));
  if (options.report.empty()) return terminal::exit_success;
  return write_report(options.report, to_html(a, b, comparison), err);
}

}  // namespace drydock::diff
