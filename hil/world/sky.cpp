#include "hil/world/sky.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "drivers/measurement/units.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/report/write_file.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/world/sky_plot.hpp"

namespace drydock::world {
namespace {

double toe_age_s(const SkyListing& listing, const SkyRow& row) {
  return measurement::seconds(listing.at - row.record.toe);
}

std::string health_of(const SkyRow& row) {
  return row.record.healthy() ? "ok" : fmt::format("bad {}", row.record.health);
}

std::string heading(const SkyListing& listing) {
  const auto week = sky::week_of(listing.at);
  auto text = fmt::format("{}  (week {}, {:.3f} s; UTC is {} s behind)\n", to_string(listing.at),
                          week.week, measurement::seconds(week.of_week),
                          sky::gps_ahead_of_utc(sky::utc_time(listing.at)).count());
  if (const auto& from = listing.from)
    text += fmt::format("from latitude {:.6f} deg, longitude {:.6f} deg, height {:.1f} m\n",
                        from->latitude_rad / units::degree, from->longitude_rad / units::degree,
                        from->height_m);
  return text;
}

void print_table(const SkyListing& listing, std::FILE* out) {
  fmt::print(out, "{}\n", heading(listing));
  const bool placed = listing.from.has_value();
  fmt::print(
      out,
      "PRN  {}health   toe age [s]       x [m]           y [m]           z [m]        clock [us]\n",
      placed ? "elevation [deg]  azimuth [deg]     range [m]  " : "");
  for (const SkyRow& row : listing.rows) {
    fmt::print(out, "G{:02}  ", row.record.prn);
    if (row.look)
      fmt::print(out, "{:15.3f}  {:13.3f}  {:12.1f}  ", row.look->elevation_rad / units::degree,
                 row.look->azimuth_rad / units::degree, row.look->range_m);
    const auto& p = row.state.ecef_m;
    fmt::print(out, "{:6} {:13.0f} {:15.3f} {:15.3f} {:15.3f} {:15.6f}\n", health_of(row),
               toe_age_s(listing, row), p.x(), p.y(), p.z(), row.state.clock_s * 1e6);
  }
  for (const auto& refused : listing.orbits.refused())
    fmt::print(out, "refused: G{:02} of line {}, toe {}: {}\n", refused.record.prn,
               refused.record.line, to_string(refused.record.toe), refused.why);
}

nlohmann::ordered_json to_json(const SkyListing& listing) {
  const auto week = sky::week_of(listing.at);
  nlohmann::ordered_json json{
      {"gps_time", to_string(listing.at)},
      {"gps_week", week.week},
      {"time_of_week_s", measurement::seconds(week.of_week)},
      {"gps_ahead_of_utc_s", sky::gps_ahead_of_utc(sky::utc_time(listing.at)).count()}};
  if (const auto& from = listing.from)
    json["from"] = {{"latitude_deg", from->latitude_rad / units::degree},
                    {"longitude_deg", from->longitude_rad / units::degree},
                    {"height_m", from->height_m}};
  json["satellites"] = nlohmann::ordered_json::array();
  for (const SkyRow& row : listing.rows) {
    nlohmann::ordered_json satellite{{"prn", row.record.prn}};
    if (row.look) {
      satellite["elevation_deg"] = row.look->elevation_rad / units::degree;
      satellite["azimuth_deg"] = row.look->azimuth_rad / units::degree;
      satellite["range_m"] = row.look->range_m;
    }
    satellite["healthy"] = row.record.healthy();
    satellite["health"] = row.record.health;
    satellite["toe_age_s"] = toe_age_s(listing, row);
    const auto& p = row.state.ecef_m;
    satellite["ecef_m"] = {p.x(), p.y(), p.z()};
    satellite["clock_s"] = row.state.clock_s;
    satellite["line"] = row.record.line;
    json["satellites"].push_back(std::move(satellite));
  }
  json["refused"] = nlohmann::ordered_json::array();
  for (const auto& refused : listing.orbits.refused())
    json["refused"].push_back({{"prn", refused.record.prn},
                               {"line", refused.record.line},
                               {"toe", to_string(refused.record.toe)},
                               {"why", refused.why}});
  return json;
}

int fail(std::FILE* errors, const std::string& why) {
  fmt::print(errors, "sky: {}\n", why);
  return terminal::exit_failed;
}

}  // namespace

SkyListing list_sky(sky::BroadcastOrbits orbits, sky::GpsTime at,
                    const std::optional<frame::Position>& from) {
  SkyListing listing{at, from, {}, std::move(orbits)};
  std::multimap<double, const sky::Ephemeris*> in_order;
  for (int prn = 1; prn <= sky::highest_prn; ++prn) {
    const auto* record = listing.orbits.nearest(prn, at);
    if (!record) record = listing.orbits.nearest(prn, at, sky::BroadcastOrbits::Health::any);
    if (!record) continue;
    in_order.emplace(from ? -look_at(*record, at, *from).elevation_rad : prn, record);
  }
  for (const auto& [order, record] : in_order) {
    SkyRow& row = listing.rows.emplace_back(SkyRow{*record, satellite_at(*record, at), {}});
    if (from) row.look = look_at(*record, at, *from);
  }
  return listing;
}

int show_sky(const SkyOptions& options, std::FILE* out, std::FILE* errors) try {
  const auto file = sky::read_navigation_file(options.ephemeris);
  if (!file) return fail(errors, file.error().message);
  const auto from = options.from ? parse_place(*options.from) : std::nullopt;
  const auto listing =
      list_sky(sky::BroadcastOrbits(file->records), parse_instant(options.at).value(), from);
  if (listing.rows.empty()) {
    const auto [first, last] = listing.orbits.span();
    return fail(
        errors,
        fmt::format("{} has no record within 2 h of {}; its records are of {} to {}",
                    options.ephemeris, to_string(listing.at), to_string(first), to_string(last)));
  }
  if (!options.plot.empty()) report::write_file(options.plot, sky_plot_svg(listing));
  if (options.json)
    fmt::print(out, "{}\n", text::json_of_any_text(to_json(listing)));
  else
    print_table(listing, out);
  return terminal::exit_success;
} catch (const std::runtime_error& error) {  // the plot cannot be written
  return fail(errors, error.what());
}

}  // namespace drydock::world
