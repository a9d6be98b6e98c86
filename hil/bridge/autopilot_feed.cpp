#include "hil/bridge/autopilot_feed.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "hil/bridge/motion_messages.hpp"

namespace drydock::bridge {

namespace {

using measurement::BottomVelocity;
namespace mavlink = wire::mavlink;

constexpr std::chrono::milliseconds oldest_sent{200};
constexpr auto rate_period = measurement::from_seconds(1 / most_per_second);
/// A DVL of 20 Hz does not arrive in even steps.
constexpr std::chrono::milliseconds rate_jitter{25};

}  // namespace

AutopilotFeed::AutopilotFeed(const FeedOptions& options, Send send, Tell tell)
    : options_(options), send_(std::move(send)), tell_(std::move(tell)) {}

void AutopilotFeed::on(const measurement::Measurement& measurement, Stamp now) {
  const std::uint16_t device = origin_of(measurement).device;
  if (const auto* imu = std::get_if<measurement::ImuSample>(&measurement)) {
    if (device == options_.imu) rotation_.add(*imu);
  } else if (const auto* ping = std::get_if<BottomVelocity>(&measurement)) {
    if (device == options_.dvl) on_ping(*ping, now);
  }
}

void AutopilotFeed::on_ping(const BottomVelocity& ping, Stamp now) {
  ++counters_.pings;
  const auto age = now - ping.origin.valid_at;
  if (!ping.velocity) {
    ++counters_.no_velocity;
    motion_.forget();
    return tell(Trouble::no_velocity, "the DVL gives no velocity (no bottom lock)");
  }
  if (age > oldest_sent) {
    ++counters_.old;
    motion_.forget();
    return tell(Trouble::old, "the DVL's velocities come more than 200 ms old");
  }
  const auto moved = motion_.add(ping.origin.valid_at, *ping.velocity, rotation_);
  if (!moved) {
    ++counters_.first;
    return;
  }
  if (!within_rate(now)) {
    ++counters_.merged;
    return;
  }
  send_motion(ping, *moved, now);
  motion_.mark();
}

bool AutopilotFeed::within_rate(Stamp now) {
  if (rate_due_ > now + rate_period) rate_due_ = now;  // the clock was set back
  if (now < rate_due_ - rate_jitter) return false;
  rate_due_ = std::max(rate_due_, now) + rate_period;
  return true;
}

void AutopilotFeed::send_motion(const BottomVelocity& ping, const Moved& moved, Stamp now) {
  bool taken = true;
  if (options_.position_delta) taken = send(position_delta(ping, moved));
  if (options_.odometry) taken = send(odometry(ping, moved)) && taken;
  if (!taken) {
    ++counters_.not_taken;
    return tell(Trouble::not_taken, "the autopilot's link does not take what is sent");
  }
  const std::chrono::nanoseconds age = now - ping.origin.valid_at;
  ++counters_.sent;
  counters_.total_age += age;
  counters_.total_interval += moved.time;
  counters_.oldest = std::max(counters_.oldest, age);
  counters_.without_rotation += !moved.rotation_known;
  tell(Trouble::none, "the motion is sent");
}

void AutopilotFeed::on_silence() {
  ++counters_.breaks;
  motion_.forget();
  tell(Trouble::silent, "the DVL is silent");
}

void AutopilotFeed::tell(Trouble trouble, std::string_view line) {
  const bool first_sent = trouble == Trouble::none && counters_.sent == 1;
  if (std::exchange(trouble_, trouble) != trouble || first_sent) tell_(line);
}

void AutopilotFeed::receive(wire::Bytes bytes, Stamp now) {
  const auto on_frame = [&](wire::Bytes frame, const device::Arrival& arrival) {
    if (const auto message = wire::Mavlink::decode(frame)) on_message(*message, arrival.read_at);
  };
  framer_.feed(bytes, now, wire::Mavlink::scan, on_frame);
}

void AutopilotFeed::on_message(const wire::Mavlink::Message& message, Stamp now) {
  if (const auto* heartbeat = std::get_if<mavlink::Heartbeat>(&message)) {
    if (heartbeat->autopilot == mavlink::Heartbeat::no_autopilot) return;
    if (counters_.autopilot_heartbeats++ == 0) tell_("the autopilot answers");
  } else if (const auto* question = std::get_if<mavlink::Timesync>(&message)) {
    if (question->tc1.count() != 0) return;
    mavlink::Timesync answer;
    answer.tc1 = now.time_since_epoch();
    answer.ts1 = question->ts1;
    answer.target_system = question->sender.system;
    answer.target_component = question->sender.component;
    send(answer);
  }
}

bool AutopilotFeed::send(wire::Mavlink::Message message) {
  std::visit(
      [&](auto& m) {
        m.sender = {options_.system, options_.component, sequence_};
      },
      message);
  std::array<std::uint8_t, wire::Mavlink::max_frame> frame;
  const std::size_t size = mavlink::encode(message, frame);
  if (!send_(wire::Bytes{frame}.first(size))) return false;
  ++sequence_;
  return true;
}

}  // namespace drydock::bridge
