#include "hil/diagnose/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::diagnose {

int tell(const Outcome& outcome, const DiagnoseOptions& options, std::FILE* out) {
  fmt::print(out, "{}", options.json ? to_json(outcome) : to_text(outcome));
  if (!options.report.empty()) {
    const auto page = std::filesystem::path(options.report) / "index.html";
    report::write_file(page, to_html(outcome));
    if (!options.json) fmt::print(out, "report: {}\n", page.string());
  }
  const bool all_heard =
      !outcome.devices.empty() &&
      std::ranges::all_of(outcome.devices, [](const auto& device) { return device.messages > 0; });
  return terminal::exit_of(outcome.findings.empty() && all_heard);
}

}  // namespace drydock::diagnose
