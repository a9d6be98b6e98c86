#include "hil/report/html.hpp"
#include "hil/twin/outcome.hpp"
#include "hil/twin/outcome_tables.hpp"

namespace drydock::twin {
namespace {

constexpr std::size_t most_points = 3000;  ///< of a curve

report::Curve way_of(const std::string& label, const track::Outcome& outcome,
                     const frame::Position& origin) {
  report::Curve curve{label, {}, {}};
  const auto& points = outcome.track.smoothed;
  for (std::size_t i = 0; i < points.size(); i += points.size() / most_points + 1) {
    const auto offset = frame::ned_offset(origin, points[i].position);
    curve.x.push_back(offset.y());
    curve.y.push_back(offset.x());
  }
  return curve;
}

}  // namespace

std::string to_html(const TwinOutcome& outcome) {
  std::string body;
  for (const auto& note : notes_of(outcome)) body += "<p>" + report::html::escaped(note) + "</p>\n";
  report::Figure map{"Map", "east [m]", "north [m]", {}};
  map.equal_scales = true;
  const auto& origin = outcome.recorded.track.smoothed.front().position;
  map.curves.push_back(way_of("track of the recording", outcome.recorded, origin));
  if (outcome.sailed)
    map.curves.push_back(way_of("track of the twin's measurements", *outcome.sailed, origin));
  body += report::html::figure(map);
  for (const auto& table : tables_of(outcome)) body += report::to_html(table);
  return report::html::page("Twin of " + outcome.source, body);
}

}  // namespace drydock::twin
