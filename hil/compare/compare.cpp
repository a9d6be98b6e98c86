#include "hil/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::compare {

int compare(const rig_config::Rig* rig, const CompareOptions& options, std::FILE* out,
            std::FILE* err) {
  try {
    const auto comparison = rig != nullptr                     ? compare_on_rig(*rig, options)
                            : track::is_recording(options)     ? compare_on_recording(options)
                            : track::goes_through_rig(options) ? compare_through_rig(options)
                                                               : compare_on_capture(options);
    fmt::print(out, "{}", options.json ? to_json(comparison) : to_text(comparison));
    if (!options.report.empty())
      report::write_file(std::filesystem::path(options.report) / "index.html", to_html(comparison));
    return terminal::exit_of(std::ranges::all_of(
        comparison.entries, [](const Entry& entry) { return entry.summary.estimates > 0; }));
  } catch (const std::invalid_argument& error) {
    fmt::print(err, "compare: {}\n", error.what());
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(err, "compare: {}\n", error.what());
    return terminal::exit_failed;
  }
}

}  // namespace drydock::compare
