#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/gpsd_log.hpp"
#include "tests/conformance/scan_positions.hpp"

/// Each position that the GNSS driver publishes must be one that gpsd reports (TPV). Each position
/// that is on the wire and in gpsd's reports must be one of the driver's.
namespace drydock::conformance {

namespace {

constexpr Rule border_rule{
    "gpsd learns the cycle",
    "the first and the last epoch of a log: gpsd reports one when it has learned which message "
    "ends it and has seen that"};
constexpr Rule gap_rule{"gpsd leaves an epoch out", "no report of the log has the epoch's time"};
constexpr Rule foreign_rule{
    "gpsd prefers another protocol",
    "the line holds frames of a binary protocol that is none of ours, and gpsd reports its "
    "positions"};
constexpr Rule high_rate_rule{
    "gpsd merges HNR-PVT",
    "the log holds u-blox's high-rate positions, and gpsd's report of an epoch has the last of "
    "them"};
constexpr Rule sibling_rule{
    "sentences of one epoch disagree",
    "GGA, RMC, GNS and GLL of one time of day say different positions: gpsd reports the last, "
    "the driver GGA's"};
constexpr Rule no_satellites_rule{
    "a fix by no satellites",
    "GGA says quality 1 and 0 satellites used: the driver takes its word, gpsd may not"};
constexpr Rule doubt_rule{
    "gpsd reports a position without a fix",
    "the receiver does not vouch for it: gnssFixOK clear or a time-only fix, quality 0, 7 or 8, "
    "status V, or a GSA beside it says that there is no fix"};

/// Anything shorter is noise on the line.
constexpr std::size_t shortest_foreign_frame = 8;

using std::chrono::milliseconds;

struct Fix {
  Position place;
  std::optional<milliseconds> time_of_day;
};

/// The positions of one log from three sources: the driver, the wire, and gpsd.
struct Positions {
  std::vector<Fix> ours;
  std::vector<Position> our_places, theirs;
  std::set<milliseconds> their_times;  ///< times of day
  std::vector<WirePosition> wire;
};

bool contains(const std::vector<Position>& places, const Position& place) {
  return std::ranges::any_of(places, [&](const Position& p) { return same_place(p, place); });
}

const Position& nearest(const std::vector<Position>& places, const Position& place) {
  return *std::ranges::min_element(places, {}, [&](const Position& p) {
    return std::max(std::abs(p.latitude_deg - place.latitude_deg),
                    std::abs(p.longitude_deg - place.longitude_deg));
  });
}

/// True if another sentence of an epoch with this place has one of `others`.
bool has_sibling(const std::vector<WirePosition>& wire, const Position& place,
                 const std::vector<Position>& others) {
  for (const WirePosition& here : wire) {
    if (!same_place(here.place, place)) continue;
    for (const WirePosition& there : wire)
      if (there.epoch == here.epoch && contains(others, there.place)) return true;
  }
  return false;
}

/// True if GGA says that no satellite gave this place.
bool by_no_satellites(const std::vector<WirePosition>& wire, const Position& place) {
  return std::ranges::any_of(
      wire, [&](const auto& w) { return w.by_no_satellites && same_place(w.place, place); });
}

bool on_wire(const std::vector<WirePosition>& wire, const Position& place) {
  return std::ranges::any_of(wire, [&](const auto& w) { return same_place(w.place, place); });
}

/// True if a sentence of an epoch with this place marks it as invalid.
bool doubted(const std::vector<WirePosition>& wire, const Position& place) {
  for (const WirePosition& here : wire) {
    if (!same_place(here.place, place)) continue;
    for (const WirePosition& there : wire)
      if (there.epoch == here.epoch && !there.vouched_for) return true;
  }
  return false;
}

Fix fix_of(const measurement::GnssFix& heard) {
  Fix fix{{heard.position->latitude_rad * degree, heard.position->longitude_rad * degree}, {}};
  if (heard.utc)
    fix.time_of_day = std::chrono::round<milliseconds>(heard.utc->time_since_epoch()) %
                      milliseconds{std::chrono::days{1}};
  return fix;
}

Positions read_positions(const Case& one, const GnssLog& log) {
  Positions p;
  for (const auto& heard :
       all_of<measurement::GnssFix>(drive(device::Kind::gnss, "ubx+nmea0183", log.bytes))) {
    if (!heard.position) continue;
    p.ours.push_back(fix_of(heard));
    p.our_places.push_back(p.ours.back().place);
  }
  if (!one.expected.empty())
    for (const json& report : gpsd_reports(one.expected, "TPV")) {
      if (const auto time = gpsd_time_of_day(report)) p.their_times.insert(*time);
      if (report.contains("lat") && report.contains("lon"))
        p.theirs.push_back({report["lat"], report["lon"]});
    }
  p.wire = scan_positions(log.bytes);
  return p;
}

/// The reason why gpsd may not report a position that our scan finds on the wire.
const Rule* reason(const Positions& p, std::size_t i, const GnssLog& log) {
  const Fix& fix = p.ours[i];
  if (!on_wire(p.wire, fix.place)) return nullptr;
  if (by_no_satellites(p.wire, fix.place)) return &no_satellites_rule;
  if (has_sibling(p.wire, fix.place, p.theirs)) return &sibling_rule;
  if (i == 0 || i + 1 == p.ours.size()) return &border_rule;
  if (fix.time_of_day && !p.their_times.empty() && !p.their_times.contains(*fix.time_of_day))
    return &gap_rule;
  if (log.high_rate > 0) return &high_rate_rule;
  if (log.foreign_bytes > shortest_foreign_frame) return &foreign_rule;
  return log.mixed() ? &mixed_rule : nullptr;
}

/// Our positions must be in theirs.
void compare_ours(const std::string& name, const Positions& p, const GnssLog& log, Score& score) {
  for (std::size_t i = 0; i < p.ours.size(); ++i) {
    const Position& ours = p.ours[i].place;
    if (!contains(p.theirs, ours)) {
      if (const Rule* rule = reason(p, i, log)) {
        score.excused(*rule);
        continue;
      }
    }
    Comparison c(name, i + 1);
    if (p.theirs.empty()) {
      c.same("position", fmt::format("{:.7f} {:.7f}", ours.latitude_deg, ours.longitude_deg),
             "none in the whole log");
    } else {
      const Position& theirs = nearest(p.theirs, ours);
      c.number("latitude", ours.latitude_deg, theirs.latitude_deg, {1e-7});
      c.number("longitude", ours.longitude_deg, theirs.longitude_deg, {1e-7});
    }
    score.add(c);
  }
}

/// Their positions must be in ours, if they are on the wire: gpsd reads more protocols than these.
void compare_theirs(const std::string& name, const Positions& p, bool mixed, Score& score) {
  std::vector<Position> seen;
  for (std::size_t i = 0; i < p.theirs.size(); ++i) {
    const Position& theirs = p.theirs[i];
    if (contains(seen, theirs) || contains(p.our_places, theirs)) continue;
    seen.push_back(theirs);
    if (!on_wire(p.wire, theirs) || has_sibling(p.wire, theirs, p.our_places)) continue;
    if (doubted(p.wire, theirs))
      score.excused(doubt_rule);
    else if (mixed)
      score.excused(mixed_rule);
    else
      score.missed(name, i + 1,
                   fmt::format("TPV {:.7f} {:.7f}", theirs.latitude_deg, theirs.longitude_deg));
  }
}

}  // namespace

std::vector<Case> discover_gpsd_positions(const fs::path& folder) {
  return gpsd_logs(folder, [](const GnssLog& log) { return log.nav_pvt + log.nmea_epochs > 0; });
}

void compare_gpsd_positions(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const GnssLog log = read_gnss_log(one.capture);
  const Positions positions = read_positions(one, log);
  if (one.expected.empty()) return score.matched(positions.ours.size());
  compare_ours(name, positions, log, score);
  compare_theirs(name, positions, log.mixed(), score);
}

}  // namespace drydock::conformance
