#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/gpsd_log.hpp"

/// Each NAV-SAT that the GNSS driver publishes must be one of the skies in gpsd's reports.
namespace drydock::conformance {

namespace {

/// gnssid, svid, C/N0, elevation, azimuth, used, as gpsd prints them.
using Satellite = std::tuple<int, int, int, int, int, bool>;
using Sky = std::set<Satellite>;

int whole(double value) { return static_cast<int>(std::lround(value)); }

/// gpsd omits satellites without a direction, and prints 0 if nothing is tracked.
Sky sky_of(const measurement::GnssSatellites& heard) {
  Sky sky;
  for (const measurement::Satellite& s : heard.satellites) {
    if (!s.elevation_rad || !s.azimuth_rad) continue;
    sky.emplace(static_cast<int>(s.constellation), s.number, whole(s.cno_dbhz.value_or(0)),
                whole(*s.elevation_rad * degree), whole(*s.azimuth_rad * degree), s.used);
  }
  return sky;
}

Sky sky_of(const json& report) {
  Sky sky;
  for (const auto& s : report.value("satellites", json::array())) {
    if (!s.contains("el") || !s.contains("az") || !s.contains("gnssid")) continue;
    sky.emplace(s.at("gnssid"), s.at("svid"), whole(s.value("ss", 0.0)), whole(s.at("el")),
                whole(s.at("az")), s.at("used"));
  }
  return sky;
}

/// The report with the most of our satellites.
const Sky& nearest(const std::set<Sky>& known, const Sky& ours) {
  return *std::ranges::max_element(known, {}, [&](const Sky& sky) {
    return std::ranges::count_if(ours, [&](const Satellite& s) { return sky.contains(s); });
  });
}

void compare_sky(const Sky& ours, const Sky& theirs, Comparison& c) {
  for (const auto& [gnss, number, cno, elevation, azimuth, used] : ours) {
    const auto same = std::ranges::find_if(theirs, [gnss = gnss, number = number](const auto& s) {
      return std::get<0>(s) == gnss && std::get<1>(s) == number;
    });
    if (same == theirs.end()) {
      c.same("satellite", std::to_string(gnss) + ":" + std::to_string(number), "not there");
      continue;
    }
    c.number("C/N0", cno, std::get<2>(*same), {1});
    c.number("elevation", elevation, std::get<3>(*same), {1});
    c.number("azimuth", azimuth, std::get<4>(*same), {1});
    c.same("used", used, std::get<5>(*same));
  }
  c.same("satellites", ours.size(), theirs.size());
}

}  // namespace

std::vector<Case> discover_gpsd_satellites(const fs::path& folder) {
  return gpsd_logs(folder, [](const GnssLog& log) { return log.nav_sat > 0; });
}

void compare_gpsd_satellites(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const GnssLog log = read_gnss_log(one.capture);
  const auto heard =
      all_of<measurement::GnssSatellites>(drive(device::Kind::gnss, "ubx+nmea0183", log.bytes));
  for (std::size_t i = heard.size(); i < log.nav_sat; ++i) score.missed(name, i + 1, "NAV-SAT");
  std::set<Sky> known;
  if (!one.expected.empty())
    for (const json& report : gpsd_reports(one.expected, "SKY")) known.insert(sky_of(report));
  if (known.empty()) return score.matched(heard.size());
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const Sky ours = sky_of(heard[i]);
    const bool reported = known.contains(ours);
    if (!reported && log.mixed()) {
      score.excused(mixed_rule);
      continue;
    }
    Comparison c(name, i + 1);
    compare_sky(ours, reported ? ours : nearest(known, ours), c);
    score.add(c);
  }
}

}  // namespace drydock::conformance
