#include "hil/track/formats.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "drivers/measurement/units.hpp"
#include "drivers/text/json_of_any_text.hpp"

namespace drydock::track {
namespace {

using smoothing::Quantity;
using smoothing::TrackPoint;
using Json = nlohmann::ordered_json;

double degrees(double radians) { return radians * units::degrees_per_radian; }

/// A height that nobody told is left out.
Json place_json(const frame::Position& p, bool has_height) {
  Json place = Json::array({degrees(p.longitude_rad), degrees(p.latitude_rad)});
  if (has_height) place.push_back(p.height_m);
  return place;
}

double sigma_of(const TrackPoint& point, int axis) {
  return std::sqrt(point.position_covariance(axis, axis));
}

Json line_json(const Outcome& outcome, std::span<const TrackPoint> points) {
  Json coordinates = Json::array(), times = Json::array(), north = Json::array(),
       east = Json::array();
  for (const auto& point : points) {
    coordinates.push_back(place_json(point.position, outcome.has_heights));
    times.push_back(utc_text(outcome.gathered.utc, point.time_s));
    north.push_back(sigma_of(point, 0));
    east.push_back(sigma_of(point, 1));
  }
  return {{"type", "Feature"},
          {"properties",
           {{"name", outcome.gathered.source},
            {"times", times},
            {"sigma_north_m", north},
            {"sigma_east_m", east}}},
          {"geometry", {{"type", "LineString"}, {"coordinates", coordinates}}}};
}

Json fix_json(const Outcome& outcome, const smoothing::Reading& fix) {
  return {{"type", "Feature"},
          {"properties",
           {{"device", outcome.gathered.device_name(fix.device)},
            {"time", utc_text(outcome.gathered.utc, fix.time_s)}}},
          {"geometry",
           {{"type", "Point"},
            {"coordinates", place_json({fix.value.x(), fix.value.y(), fix.value.z()},
                                       std::isfinite(fix.value.z()))}}}};
}

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::optional<Format> format_of(std::string_view name) {
  if (name == "geojson") return Format::geojson;
  if (name == "gpx") return Format::gpx;
  if (name == "csv") return Format::csv;
  if (name == "mcap") return Format::mcap;
  return {};
}

std::vector<TrackPoint> thinned(const Outcome& outcome, double every_s) {
  std::vector<TrackPoint> points;
  const auto& all = outcome.track.smoothed;
  for (const auto& point : all)
    if (points.empty() || point.time_s - points.back().time_s >= every_s * (1 - 1e-9) ||
        &point == &all.back())
      points.push_back(point);
  return points;
}

std::string utc_text(measurement::Stamp start, double time_s) {
  const auto at = (start + measurement::from_seconds(time_s)).time_since_epoch();
  const auto ms =
      std::chrono::floor<std::chrono::milliseconds>(at + std::chrono::microseconds{500});
  const auto seconds = std::chrono::floor<std::chrono::seconds>(ms);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z",
                     fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     (ms - seconds).count());
}

std::string to_geojson(const Outcome& outcome, std::span<const TrackPoint> points) {
  Json features = Json::array({line_json(outcome, points)});
  for (const auto& reading : outcome.gathered.dive.readings)
    if (reading.quantity == Quantity::fix) features.push_back(fix_json(outcome, reading));
  const Json json{{"type", "FeatureCollection"}, {"features", features}};
  return text::json_of_any_text(json, -1) + "\n";
}

std::string to_gpx(const Outcome& outcome, std::span<const TrackPoint> points) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<gpx version=\"1.1\" creator=\"Drydock\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
      "<trk><name>{}</name><trkseg>\n",
      xml_escaped(outcome.gathered.source));
  for (const auto& p : points)
    out += fmt::format(
        "<trkpt lat=\"{:.9f}\" lon=\"{:.9f}\">{}<time>{}</time></trkpt>\n",
        degrees(p.position.latitude_rad), degrees(p.position.longitude_rad),
        outcome.has_heights ? fmt::format("<ele>{:.3f}</ele>", p.position.height_m) : "",
        utc_text(outcome.gathered.utc, p.time_s));
  return out + "</trkseg></trk>\n</gpx>\n";
}

std::string to_csv(const Outcome& outcome, std::span<const TrackPoint> points) {
  std::string out =
      "time_s,utc,latitude_deg,longitude_deg,height_m,velocity_north_mps,velocity_east_mps,"
      "velocity_down_mps,roll_deg,pitch_deg,heading_deg,sigma_north_m,sigma_east_m,sigma_height_m,"
      "correlation_north_east,sigma_heading_deg\n";
  const auto of_height = [&](double value) {
    return outcome.has_heights ? fmt::format("{:.4f}", value) : std::string();
  };
  for (const auto& p : points) {
    const double correlation = p.position_covariance(0, 1) / (sigma_of(p, 0) * sigma_of(p, 1));
    const double heading = degrees(p.attitude.yaw) + (p.attitude.yaw < 0 ? 360 : 0);
    out += fmt::format(
        "{:.6f},{},{:.9f},{:.9f},{},{:.5f},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},"
        "{},{:.4f},{:.4f}\n",
        p.time_s, utc_text(outcome.gathered.utc, p.time_s), degrees(p.position.latitude_rad),
        degrees(p.position.longitude_rad), of_height(p.position.height_m), p.velocity_ned.x(),
        p.velocity_ned.y(), p.velocity_ned.z(), degrees(p.attitude.roll), degrees(p.attitude.pitch),
        heading, sigma_of(p, 0), sigma_of(p, 1), of_height(sigma_of(p, 2)),
        std::isfinite(correlation) ? correlation : 0, degrees(p.heading_sigma_rad));
  }
  return out;
}

}  // namespace drydock::track
