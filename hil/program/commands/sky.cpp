#include <fmt/format.h>

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/world/sky.hpp"

namespace drydock::program {

namespace {

const CLI::Validator instant_text(
    [](std::string& text) {
      if (world::parse_instant(text)) return std::string{};
      return fmt::format(
          "'{}' is no instant; allowed: 2010-07-01T12:00:00Z (UTC) or '2010-07-01T12:00:00 GPS'",
          text);
    },
    "TIME");
const CLI::Validator place_text(
    [](std::string& text) {
      if (world::parse_place(text)) return std::string{};
      return fmt::format("'{}' is no place; allowed: latitude,longitude[,height] in deg and m",
                         text);
    },
    "LAT,LON,H");

}  // namespace

void add_sky(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::SkyOptions>();
  auto* sub = app.add_subcommand("sky", "GPS satellites of a broadcast ephemeris at one instant");
  sub->footer(
      "Example: drydock sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:00:00Z \\\n"
      "                     --from 36.0,129.0,0 --plot sky.svg");
  sub->add_option("--ephemeris", options->ephemeris, "RINEX 2 or 3 GPS navigation file")
      ->required();
  sub->add_option("--at", options->at,
                  "2010-07-01T12:00:00Z (UTC; also without Z) or '2010-07-01T12:00:00 GPS'")
      ->required()
      ->check(instant_text);
  auto* from = sub->add_option("--from", options->from,
                               "latitude and longitude in deg, height over the ellipsoid in m: "
                               "elevation, azimuth and range from there")
                   ->check(place_text);
  sub->add_flag("--json", options->json, "JSON instead of a table");
  sub->add_option("--plot", options->plot, "write a sky plot to this SVG file")->needs(from);
  sub->callback([options, &command] {
    command = [options] { return world::show_sky(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
