#pragma once

#include <span>
#include <string>

#include "hil/track/outcome.hpp"

namespace drydock::track {

enum class Format : std::uint8_t { geojson, gpx, csv, mcap };

/// Empty if no format has that name.
std::optional<Format> format_of(std::string_view name);

/// Points of the smoothed track, at least `every_s` apart, and always the last one. 0: all.
std::vector<smoothing::TrackPoint> thinned(const Outcome& outcome, double every_s);

/// UTC of a time of the dive: 2026-11-21T08:00:00.250Z. A capture without times counts from 1970.
std::string utc_text(measurement::Stamp start, double time_s);

/// RFC 7946: a line of [longitude, latitude, height], with times and sigmas beside it, and the
/// fixes as points.
std::string to_geojson(const Outcome& outcome, std::span<const smoothing::TrackPoint> points);

/// GPX 1.1: one track; heights are above the ellipsoid.
std::string to_gpx(const Outcome& outcome, std::span<const smoothing::TrackPoint> points);

/// A line for each point; the first one names the columns.
std::string to_csv(const Outcome& outcome, std::span<const smoothing::TrackPoint> points);

/// A recording with the rig's files, and the estimates "smoothed" and "filtered" of all epochs.
/// Throws std::runtime_error with one line if it cannot be written.
void write_mcap(const Outcome& outcome, const std::string& path, bool overwrite);

}  // namespace drydock::track
