#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/twin/outcome.hpp"
#include "hil/twin/outcome_tables.hpp"

namespace drydock::twin {
namespace {

using Json = nlohmann::ordered_json;

Json axes_json(const DeviceStatistics& statistics) {
  Json all = Json::array();
  for (const auto& noise : statistics.quantities)
    for (std::size_t i = 0; i < noise.axes.size(); ++i) {
      const auto& axis = noise.axes.at(i);
      if (!axis) continue;
      all.push_back({{"quantity", noise.quantity.name},
                     {"axis", noise.quantity.axes.at(i)},
                     {"values", axis->values},
                     {"mean", axis->mean},
                     {"sigma", axis->sigma},
                     {"white", axis->white},
                     {"slow", axis->slow},
                     {"correlation_s", axis->correlation_s}});
    }
  return all;
}

Json statistics_json(const DeviceStatistics& s) {
  return {{"samples", s.timing.samples},
          {"rate_hz", s.timing.rate_hz},
          {"outages", s.timing.outages},
          {"lost", s.timing.lost},
          {"longest_gap_s", s.timing.longest_gap_s},
          {"without_value", s.empty},
          {"errors", axes_json(s)}};
}

Json innovations_json(const track::Outcome& outcome) {
  Json all = Json::array();
  for (const auto& s : outcome.sensors)
    all.push_back({{"device", s.device},
                   {"quantity", track::name_of(s.quantity)},
                   {"unit", track::unit_of(s.quantity)},
                   {"readings", s.readings},
                   {"rms", s.rms},
                   {"nis", s.nis}});
  return all;
}

}  // namespace

std::string to_text(const TwinOutcome& outcome) {
  std::string out = fmt::format("{} -> {}: {} poses, one every {:.3g} s, {:.0f} m in {:.1f} s\n",
                                outcome.source, outcome.folder, outcome.poses, outcome.every_s,
                                outcome.recorded.distance_m, outcome.recorded.duration_s);
  for (const auto& note : notes_of(outcome)) out += "  " + note + "\n";
  for (const auto& table : tables_of(outcome)) out += "\n" + report::to_text(table);
  return out;
}

std::string to_json(const TwinOutcome& outcome) {
  Json json{{"source", outcome.source},
            {"folder", outcome.folder},
            {"poses", outcome.poses},
            {"every_s", outcome.every_s},
            {"duration_s", outcome.recorded.duration_s},
            {"distance_m", outcome.recorded.distance_m},
            {"notes", notes_of(outcome)},
            {"devices", Json::array()}};
  for (const auto& device : outcome.devices)
    json["devices"].push_back({{"device", device.name},
                               {"kind", to_string(device.kind)},
                               {"recorded", statistics_json(device.recorded)},
                               {"twin", statistics_json(device.twin)}});
  json["innovations"] = {{"recorded", innovations_json(outcome.recorded)}};
  if (outcome.sailed) json["innovations"]["twin"] = innovations_json(*outcome.sailed);
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::twin
