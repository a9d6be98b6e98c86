#include "hil/score/estimate_topic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "drivers/text/printable.hpp"
#include "hil/replay/reference/references.hpp"
#include "hil/score/attitude.hpp"
#include "hil/score/turned.hpp"

namespace drydock::score {
namespace {

MessageValues values_of(const record::MessageNode& layout, mcap::Bytes cdr) {
  MessageValues values;
  for (const auto& [name, value] : replay::values_of(layout, cdr)) {
    if (value.is_string()) {
      if (name == "header.frame_id") values.frame = value.get<std::string>();
    } else {
      values.numbers[name] =
          value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return values;
}

bool tells(const Eigen::Vector3d& v) { return !v.array().isNaN().all(); }

void add_to(State& state, const State& other) {
  if (!tells(state.position_ned)) {
    state.position_ned = other.position_ned;
    state.position_m2 = other.position_m2;
  }
  if (!tells(state.angles)) {
    state.angles = other.angles;
    state.angles_rad2 = other.angles_rad2;
  }
  if (!tells(state.velocity)) {
    state.velocity = other.velocity;
    state.velocity_in_body = other.velocity_in_body;
    state.velocity_m2ps2 = other.velocity_m2ps2;
  }
}

/// With an attitude of its own an estimate tells its velocity in NED.
void turn_velocity(State& state) {
  const auto attitude = attitude_of(state);
  if (!state.velocity_in_body || !attitude || state.velocity.hasNaN()) return;
  const Eigen::Matrix3d to_ned = attitude->toRotationMatrix();
  state.velocity = to_ned * state.velocity;
  state.velocity_m2ps2 = turned(to_ned, state.velocity_m2ps2);
  state.velocity_in_body = false;
}

}  // namespace

void EstimateTopic::note(const std::string& why) {
  passed_over_.add(text::printable(why), messages_);
}

void EstimateTopic::read(const record::Layout& layout, mcap::Bytes cdr) {
  ++messages_;
  if (!layout) return note(layout.error().line);
  if (const auto why = record::misfit(*layout, cdr); !why.empty()) return note(why);
  const auto values = values_of(*layout, cdr);
  for (const char* field : type_.fields)
    if (!values.has(field)) return note(fmt::format("it has no {}", field));
  take(type_.read(values, origin_));
}

void EstimateTopic::take(MessageState message) {
  for (const auto& remark : message.remarks) note(remark);
  default_attitudes_ &= message.default_attitude;
  default_velocities_ &= message.default_velocity;
  if (message.state.says_anything()) estimates_.track.push_back(std::move(message.state));
}

Estimates EstimateTopic::result() {
  auto& track = estimates_.track;
  estimates_.notes = passed_over_.notes();
  if (track.size() > 1 && default_attitudes_) {
    estimates_.notes.emplace_back(
        "no attitude: the orientation is 0 0 0 1 in every message, as in an empty one");
    for (State& state : track) state.angles = untold();
  }
  if (track.size() > 1 && default_velocities_) {
    estimates_.notes.emplace_back(
        "no velocity: it is 0 without a covariance in every message, as in an empty one");
    for (State& state : track) state.velocity = untold();
  }
  std::erase_if(track, [](const State& state) { return !state.says_anything(); });
  std::ranges::for_each(track, turn_velocity);
  return std::move(estimates_);
}

void add_to(Track& track, const Track& other) {
  if (track.empty()) track = other;
  std::map<measurement::Stamp, const State*> by_time;
  for (const State& state : other) by_time[state.at] = &state;
  for (State& state : track)
    if (const auto same = by_time.find(state.at); same != by_time.end())
      add_to(state, *same->second);
}

}  // namespace drydock::score
