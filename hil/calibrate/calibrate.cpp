#include "hil/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/calibrate/outcome.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::calibrate {
namespace {

void write_rig(const Outcome& outcome, const CalibrateOptions& options, std::FILE* err) {
  if (outcome.gathered.rig_text.empty())
    throw std::runtime_error("a capture has no rig file to write into");
  if (!outcome.calibration.converged)
    throw std::runtime_error(
        "the search did not settle: nothing is written. The residuals of --report show what does "
        "not "
        "fit; --only leaves a sensor out");
  std::vector<std::string> notes;
  report::write_file(options.write, calibrated_rig(outcome, notes));
  for (const auto& note : notes) fmt::print(err, "{}\n", note);
  fmt::print(err, "{} written: what the dive told; files that it names are relative to it\n",
             options.write);
}

}  // namespace

int calibrate(const CalibrateOptions& options, std::FILE* out, std::FILE* err) {
  try {
    if (std::filesystem::is_directory(options.write)) {
      fmt::print(err, "calibrate: {} is a folder, not a file\n", options.write);
      return terminal::exit_failed;
    }
    if (!options.write.empty() && !options.overwrite && std::filesystem::exists(options.write)) {
      fmt::print(err, "calibrate: {} exists; --overwrite replaces it\n", options.write);
      return terminal::exit_failed;
    }
    const auto outcome = calibrated(track::gather(options.source));
    fmt::print(out, "{}", options.json ? to_json(outcome) : to_text(outcome));
    if (!options.report.empty())
      report::write_file(std::filesystem::path(options.report) / "index.html", to_html(outcome));
    if (!options.write.empty()) write_rig(outcome, options, err);
    return terminal::exit_of(std::ranges::any_of(outcome.calibration.findings, [](const auto& f) {
      return f.verdict == calibration::Verdict::told;
    }));
  } catch (const track::BadOptions& error) {
    fmt::print(err, "calibrate: {}\n", error.what());
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(err, "calibrate: {}\n", error.what());
    return terminal::exit_failed;
  }
}

}  // namespace drydock::calibrate
