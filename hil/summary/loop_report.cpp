#include "hil/summary/loop_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hil/report/html.hpp"
#include "hil/report/table.hpp"

namespace drydock::summary {

namespace {

using Json = nlohmann::ordered_json;

std::string difference_text(const pilot::LoopAccount& loop) {
  return fmt::format(
      "Beside the autopilots inside the simulation the vehicle was off by at most {:.2f} deg of "
      "heading, {:.3f} m of depth, {:.3f} m/s of speed, {:.2f} m of place.",
      loop.heading_off_deg, loop.depth_off_m, loop.speed_off_mps, loop.place_off_m);
}

report::Table table_of(const pilot::LoopAccount& loop) {
  report::Table table;
  table.title = "Steered over the wires";
  table.columns = {"leg", "from", "to", "overshoot", "settled after", "steady error"};
  for (const auto& r : loop.responses) {
    const auto with_unit = [&](double value, int digits) {
      return fmt::format("{:.{}f} {}", value, digits, r.unit);
    };
    table.rows.push_back({fmt::format("{} at {:.0f} s", r.quantity, r.begins_s),
                          with_unit(r.from, 1), with_unit(r.to, 1), with_unit(r.overshoot, 3),
                          r.settling_s ? fmt::format("{:.1f} s", *r.settling_s) : "-",
                          r.steady_error ? with_unit(*r.steady_error, 3) : "-"});
  }
  table.note = difference_text(loop);
  return table;
}

report::Table waypoints_table(const pilot::LoopAccount& loop) {
  report::Table table;
  table.title = "Waypoints";
  table.columns = {"waypoint", "north", "east", "passed", "off its line at most", "in the end"};
  for (std::size_t i = 1; i < loop.waypoints.size(); ++i) {
    const auto& w = loop.waypoints[i];
    const auto metres = [](double value, int digits) {
      return fmt::format("{:.{}f} m", value, digits);
    };
    const std::string passed =
        w.passed_s ? fmt::format("{:.1f} s{}", *w.passed_s, w.reached ? "" : ", missed") : "-";
    const bool begun = w.passed_s || w.cross_track_max_m > 0;
    table.rows.push_back({fmt::format("{}", i + 1), metres(w.north_m, 1), metres(w.east_m, 1),
                          passed, begun ? metres(w.cross_track_max_m, 2) : "-",
                          w.passed_s ? metres(w.cross_track_end_m, 2) : "-"});
  }
  table.note = loop.waypoints.back().passed_s
                   ? "All waypoints are behind; the vehicle goes straight on. By the truth."
                   : "The run ended before the last waypoint. By the truth.";
  return table;
}

report::Figure figure_of(const char* title, const char* unit, const std::vector<double>& t_s,
                         const pilot::LoopCurve& curve) {
  return {title,
          "time [s]",
          unit,
          {{"wanted", t_s, curve.wanted},
           {"over the wires", t_s, curve.is},
           {"inside the simulation", t_s, curve.in_process}}};
}

}  // namespace

std::string loop_text(const pilot::LoopAccount& loop) {
  std::string text =
      loop.responses.empty() ? difference_text(loop) + "\n" : to_text(table_of(loop));
  if (!loop.waypoints.empty()) text += to_text(waypoints_table(loop));
  return text;
}

Json loop_json(const pilot::LoopAccount& loop) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  Json responses = Json::array();
  for (const auto& r : loop.responses)
    responses.push_back({{"quantity", r.quantity},
                         {"unit", r.unit},
                         {"begins_s", r.begins_s},
                         {"from", r.from},
                         {"to", r.to},
                         {"overshoot", r.overshoot},
                         {"settling_s", or_null(r.settling_s)},
                         {"steady_error", or_null(r.steady_error)}});
  Json waypoints = Json::array();
  for (const auto& w : loop.waypoints)
    waypoints.push_back({{"north_m", w.north_m},
                         {"east_m", w.east_m},
                         {"radius_m", w.radius_m},
                         {"passed_s", or_null(w.passed_s)},
                         {"reached", w.reached},
                         {"cross_track_max_m", w.cross_track_max_m},
                         {"cross_track_end_m", w.cross_track_end_m}});
  return {{"heading_off_deg", loop.heading_off_deg}, {"depth_off_m", loop.depth_off_m},
          {"speed_off_mps", loop.speed_off_mps},     {"place_off_m", loop.place_off_m},
          {"responses", std::move(responses)},       {"waypoints", std::move(waypoints)}};
}

std::string loop_section(const pilot::LoopAccount& loop) {
  const auto& trace = loop.trace;
  report::Figure depth = figure_of("Depth", "m", trace.t_s, trace.depth_m);
  depth.y_down = true;
  return to_html(table_of(loop)) + (loop.waypoints.empty() ? "" : to_html(waypoints_table(loop))) +
         report::html::figure(figure_of("Heading", "deg", trace.t_s, trace.heading_deg)) +
         report::html::figure(depth) +
         report::html::figure(
             figure_of("Speed through the water", "m/s", trace.t_s, trace.speed_mps));
}

}  // namespace drydock::summary
