#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "hil/motion/maneuver/maneuver.hpp"

namespace drydock::motion {

namespace {

using namespace element;

using Value = std::optional<double>;
using Points = std::vector<Track::const_iterator>;

/// The first point at which the command moves the rudder or the stern planes away from amidships.
Track::const_iterator execute(const Track& track) {
  return std::ranges::find_if(track, [](const TrackPoint& point) {
    return point.command.delta_r != 0 || point.command.delta_s != 0;
  });
}

/// The points at which the command moves a surface to the other side.
Points reversals(const Track& track, double Command::*surface) {
  Points found;
  for (auto at = std::next(track.begin()); at < track.end(); ++at)
    if (at->command.*surface * std::prev(at)->command.*surface < 0) found.push_back(at);
  return found;
}

/// The next point at which the commanded rudder differs from that at `start`.
Track::const_iterator rudder_moved(Track::const_iterator start, const Track& track) {
  return std::find_if(start, track.end(), [&](const TrackPoint& point) {
    return point.command.delta_r != start->command.delta_r;
  });
}

/// Time and state at which element i of the state first passes a value.
struct Passing {
  double t;
  hydrodynamics::State state;
};
std::optional<Passing> passing(Track::const_iterator from, Track::const_iterator until, int i,
                               double value) {
  for (auto next = std::next(from); next < until; from = next++) {
    const double a = from->state[i], b = next->state[i];
    if ((a - value) * (b - value) > 0 || a == b) continue;
    const double part = (value - a) / (b - a);
    return Passing{from->t + part * (next->t - from->t),
                   from->state + part * (next->state - from->state)};
  }
  return {};
}

double rate_of_turn(const hydrodynamics::State& s) {
  return (s[q] * std::sin(s[roll]) + s[r] * std::cos(s[roll])) / std::cos(s[pitch]);
}

/// Uses the track while the rudder is as at the execute. Later parts of a schedule are not this
/// circle.
std::vector<Figure> of_turning_circle(const Track& track, Track::const_iterator start) {
  const auto moved = rudder_moved(start, track);
  const auto& end = std::prev(moved)->state;
  const double side = end[yaw] < start->state[yaw] ? -1 : 1;
  const auto turned = [&](double angle_deg) {
    return passing(start, moved, yaw,
                   start->state[yaw] + side * angle_deg / units::degrees_per_radian);
  };
  const auto quarter = turned(90), half = turned(180), full = turned(360);
  const auto distance = [&](const auto& at, int i) {
    return at ? Value(std::abs(at->state[i] - start->state[i])) : Value();
  };
  const auto after = [&](const auto& at) { return at ? Value(at->t - start->t) : Value(); };
  const double speed = end.head<3>().norm(), before = start->state.head<3>().norm();
  const double diameter = 2 * speed * std::cos(end[pitch]) / std::abs(rate_of_turn(end));
  const auto steady = [&](double value) { return full ? Value(value) : Value(); };
  return {
      {"advance", "m", distance(quarter, x)},
      {"transfer", "m", distance(quarter, y)},
      {"tactical diameter", "m", distance(half, y)},
      {"steady turning diameter", "m", steady(diameter)},
      {"time to 90 deg", "s", after(quarter)},
      {"time to 180 deg", "s", after(half)},
      {"time to 360 deg", "s", after(full)},
      {"steady rate of turn", "deg/s", steady(rate_of_turn(end) * units::degrees_per_radian)},
      {"steady speed", "m/s", steady(speed)},
      {"speed lost", "%", before > 0 ? steady(100 * (1 - speed / before)) : Value()},
      {"steady drift angle", "deg",
       steady(-std::atan2(end[v], end[u]) * units::degrees_per_radian)},
      {"steady roll", "deg", steady(end[roll] * units::degrees_per_radian)},
  };
}

/// The largest further change of element i after `at`, until `until`.
double overshoot(Track::const_iterator at, Track::const_iterator until, int i) {
  const double side = at->state[i] < 0 ? -1 : 1;
  double most = 0;
  for (auto point = at; point != until; ++point)
    most = std::max(most, side * (point->state[i] - at->state[i]));
  return most;
}

std::vector<Figure> of_zigzag(const Track& track, Track::const_iterator start) {
  const Points turns = reversals(track, &Command::delta_r);
  const auto between = [&](std::size_t a, std::size_t b) {
    return b < turns.size() ? Value(turns[b]->t - turns[a]->t) : Value();
  };
  std::vector<Figure> found{
      {"initial turning time", "s", turns.empty() ? Value() : Value(turns[0]->t - start->t)},
      {"time between first and second reversal", "s", between(0, 1)},
      {"period", "s", between(1, 3)},
  };
  constexpr const char* ordinals[] = {"first", "second", "third", "fourth"};
  for (std::size_t i = 0; i < std::size(ordinals); ++i) {
    const bool seen = i + 1 < turns.size();
    found.push_back({std::string(ordinals[i]) + " overshoot", "deg",
                     seen
                         ? Value(overshoot(turns[i], turns[i + 1], yaw) * units::degrees_per_radian)
                         : Value()});
  }
  return found;
}

std::vector<Figure> of_spiral(const Track& track) {
  const auto points = spiral_points(track);
  Value amidships, loop;
  for (const SpiralPoint& there : points) {
    if (there.returning) continue;
    if (there.rudder_rad == 0) amidships = there.rate_of_turn_radps * units::degrees_per_radian;
    const auto back = std::ranges::find_if(points, [&](const SpiralPoint& point) {
      return point.returning && point.rudder_rad == there.rudder_rad;
    });
    if (back == points.end()) continue;
    const double height =
        std::abs(back->rate_of_turn_radps - there.rate_of_turn_radps) * units::degrees_per_radian;
    loop = std::max(loop.value_or(0), height);
  }
  return {{"rate of turn, rudder amidships", "deg/s", amidships},
          {"height of the loop", "deg/s", loop}};
}

std::vector<Figure> of_dive(const Track& track, Track::const_iterator start) {
  const Points turns = reversals(track, &Command::delta_s);
  const auto of_reversal = [&](auto&& value) {
    return turns.empty() ? Value() : Value(value(turns.front()));
  };
  const auto level =
      std::ranges::find_if(turns.empty() ? track.end() : turns.front(), track.end(),
                           [](const TrackPoint& point) { return descent_rate(point.state) <= 0; });
  const auto of_level = [&](auto&& value) {
    return level == track.end() ? Value() : Value(value());
  };
  return {
      {"time to reversal", "s", of_reversal([&](auto at) { return at->t - start->t; })},
      {"depth gained to reversal", "m",
       of_reversal([&](auto at) { return at->state[z] - start->state[z]; })},
      {"pitch overshoot", "deg", of_level([&] {
         return overshoot(turns.front(), level, pitch) * units::degrees_per_radian;
       })},
      {"depth overshoot", "m",
       of_level([&] { return overshoot(turns.front(), std::next(level), z); })},
      {"time from reversal to level", "s", of_level([&] { return level->t - turns.front()->t; })},
  };
}

}  // namespace

std::vector<SpiralPoint> spiral_points(const Track& track) {
  std::vector<SpiralPoint> points;
  bool returning = false;
  double before = 0;
  for (auto at = execute(track); at < track.end(); ++at) {
    const auto next = std::next(at);
    const double rudder = at->command.delta_r;
    if (next != track.end() && next->command.delta_r == rudder) continue;
    returning = returning || (!points.empty() && rudder > before);
    before = rudder;
    const auto& settled = next == track.end() ? *at : *next;
    points.push_back({rudder, rate_of_turn(settled.state), returning});
  }
  return points;
}

std::vector<Figure> figures(ManeuverKind kind, const Track& track) {
  const auto start = execute(track);
  if (start == track.end()) return {};
  switch (kind) {
    case ManeuverKind::turning_circle: return of_turning_circle(track, start);
    case ManeuverKind::zigzag: return of_zigzag(track, start);
    case ManeuverKind::spiral: return of_spiral(track);
    case ManeuverKind::dive: break;
  }
  return of_dive(track, start);
}

}  // namespace drydock::motion
