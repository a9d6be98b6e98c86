#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/gpsd_log.hpp"

/// Compares NMEA 2000 logs with gpsd: each depth report, and each GNSS position (PGN 129029) with
/// the reports (TPV) of its time.
namespace drydock::conformance {

namespace {

using Milliseconds = std::int64_t;  // time of day

Milliseconds time_of(const json& position) {
  constexpr std::int64_t day_ms = 86'400'000, ms_ns = 1'000'000;
  return position["utc_ns"].get<std::int64_t>() / ms_ns % day_ms;
}

/// The sender that gpsd names in `nmea2000://vcan0:17`; -1 if it names none.
int source_of(const json& report) {
  const std::string device = report.value("device", "");
  const auto colon = device.rfind(':');
  const bool named = colon != std::string::npos && colon > device.find("//") + 1;
  return named ? std::atoi(device.c_str() + colon + 1) : -1;
}

void compare_depths(const std::string& name, const std::vector<json>& decoded,
                    const std::vector<json>& reports, Score& score) {
  std::map<int, std::deque<json>> by_source;
  for (const json& message : decoded)
    if (message["type"] == "water_depth") by_source[message["source"]].push_back(message);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!reports[i].contains("depth")) continue;
    auto& queue = by_source[source_of(reports[i])];
    if (queue.empty()) {
      score.missed(name, i + 1, reports[i].dump());
      continue;
    }
    Comparison c(name, i + 1);
    c.number("depth", queue.front()["depth_m"], reports[i]["depth"], {0.01});
    queue.pop_front();
    score.add(c);
  }
  for (const auto& [source, queue] : by_source)
    for (const json& left : queue) score.unexpected(name, 0, left.dump());
}

double distance(const json& ours, const json& report) {
  return std::max(std::abs(double(ours["latitude_rad"]) * degree - double(report["lat"])),
                  std::abs(double(ours["longitude_rad"]) * degree - double(report["lon"])));
}

void compare_position(const json& ours, const json& report, Comparison& c) {
  c.number("latitude", double(ours["latitude_rad"]) * degree, report["lat"], {1e-7});
  c.number("longitude", double(ours["longitude_rad"]) * degree, report["lon"], {1e-7});
  c.number("ellipsoidal height", ours["altitude_m"], report.value("altHAE", json()), {1e-4});
  c.number("geoid separation", ours["geoid_height_m"], report.value("geoidSep", json()), {0.01});
}

void compare_positions(const std::string& name, const std::vector<json>& decoded,
                       const std::vector<json>& reports, Score& score) {
  std::multimap<Milliseconds, const json*> by_time;
  for (const json& report : reports)
    if (const auto time = gpsd_time_of_day(report); time && report.contains("lat"))
      by_time.emplace(time->count(), &report);
  std::size_t number = 0;
  for (const json& ours : decoded) {
    if (ours["type"] != "gnss_position" || ours["latitude_rad"].is_null() ||
        ours["utc_ns"].is_null())
      continue;
    Comparison c(name, ++number);
    const auto [first, last] = by_time.equal_range(time_of(ours));
    if (first == last) {
      score.unexpected(name, number, ours.dump());
      continue;
    }
    compare_position(ours,
                     *std::min_element(first, last,
                                       [&](const auto& a, const auto& b) {
                                         return distance(ours, *a.second) <
                                                distance(ours, *b.second);
                                       })
                          ->second,
                     c);
    score.add(c);
  }
}

}  // namespace

std::vector<Case> discover_gpsd_nmea2000(const fs::path& folder) {
  return paired(files_of(folder, ".log"), files_of(folder, ".chk"),
                [](fs::path log) { return log += ".chk"; });
}

void compare_gpsd_nmea2000(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const auto decoded = decode("nmea2000", one.capture).messages;
  if (one.expected.empty()) return score.matched(decoded.size());
  compare_depths(name, decoded, gpsd_reports(one.expected, "ATT"), score);
  compare_positions(name, decoded, gpsd_reports(one.expected, "TPV"), score);
}

}  // namespace drydock::conformance
