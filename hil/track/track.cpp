#include "hil/track/track.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "estimators/smoothing/tilt_smoother.hpp"
#include "hil/report/write_file.hpp"
#include "hil/track/formats.hpp"

namespace drydock::track {
namespace {

std::optional<Format> wanted_format(const TrackOptions& options) {
  if (options.out.empty()) return {};
  const auto extension = std::filesystem::path(options.out).extension().string();
  const std::string name =
      !options.as.empty() || extension.empty() ? options.as : extension.substr(1);
  const auto format = format_of(name);
  if (!format)
    throw BadOptions(options.out + ": --as says the format: one of geojson, gpx, csv, mcap");
  if (std::filesystem::is_directory(options.out))
    throw std::runtime_error(options.out + " is a folder, not a file");
  if (!options.overwrite && std::filesystem::exists(options.out))
    throw std::runtime_error(options.out + " exists; --overwrite replaces it");
  return format;
}

void write(const Outcome& outcome, const TrackOptions& options, Format format) {
  if (format == Format::mcap) return write_mcap(outcome, options.out, options.overwrite);
  const auto points = thinned(outcome, options.every_s);
  const auto text = format == Format::geojson ? to_geojson(outcome, points)
                    : format == Format::gpx   ? to_gpx(outcome, points)
                                              : to_csv(outcome, points);
  report::write_file(options.out, text);
}

}  // namespace

Gathered gather(const DiveSource& dive, host::Follower* also) {
  if (is_recording(dive)) return gather_recording(dive.source.capture, dive.part, dive.rig, also);
  try {
    return goes_through_rig(dive) ? gather_captures(dive, also) : gather_capture(dive, also);
  } catch (const std::invalid_argument& error) {
    throw BadOptions(error.what());
  }
}

int track(const TrackOptions& options, std::FILE* out, std::FILE* err) {
  try {
    const auto format = wanted_format(options);
    auto gathered = gather(options);
    // A twin takes the tilts as they were sent: its poses average them.
    gathered.dive.tilts = smoothing::smooth_tilts(std::move(gathered.dive.tilts));
    const auto outcome = smoothed(std::move(gathered), options.model, options.origin);
    fmt::print(out, "{}", options.json ? to_json(outcome) : to_text(outcome));
    if (format) write(outcome, options, *format);
    if (!options.report.empty())
      report::write_file(std::filesystem::path(options.report) / "index.html", to_html(outcome));
    return terminal::exit_success;
  } catch (const BadOptions& error) {
    fmt::print(err, "track: {}\n", error.what());
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(err, "track: {}\n", error.what());
    return terminal::exit_failed;
  }
}

}  // namespace drydock::track
