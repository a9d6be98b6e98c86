#include "hil/motion/steered/steered_trajectory.hpp"

#include <utility>

#include "estimators/frame/attitude.hpp"

namespace drydock::motion {
namespace {

constexpr std::size_t kept_moments = 1024;
constexpr std::chrono::milliseconds largest_lead{100};

/// Between two moments of a step, which is short: linear, but for the attitude.
Truth between(const Truth& a, const Truth& b, double share) {
  Truth t = b;
  const auto mix = [&](const auto& from, const auto& to) { return from + share * (to - from); };
  t.latitude_rad = mix(a.latitude_rad, b.latitude_rad);
  t.longitude_rad = a.longitude_rad + share * frame::wrap_pi(b.longitude_rad - a.longitude_rad);
  t.height_m = mix(a.height_m, b.height_m);
  t.body_to_ned = a.body_to_ned.slerp(share, b.body_to_ned);
  const frame::Euler attitude = frame::euler(t.body_to_ned);
  t.roll_rad = attitude.roll;
  t.pitch_rad = attitude.pitch;
  t.yaw_rad = attitude.yaw;
  t.velocity_ned = mix(a.velocity_ned, b.velocity_ned);
  t.velocity_body = mix(a.velocity_body, b.velocity_body);
  t.specific_force = mix(a.specific_force, b.specific_force);
  t.angular_rate = mix(a.angular_rate, b.angular_rate);
  t.rate_body = mix(a.rate_body, b.rate_body);
  return t;
}

}  // namespace

SteeredTrajectory::SteeredTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : start_(start), vehicle_(make_steered_vehicle(mission)) {
  past_.reserve(kept_moments);
  past_.push_back({0, vehicle_->truth()});
}

void SteeredTrajectory::step(std::span<const double> outputs, double dt, Stamp now) {
  const std::lock_guard lock(mutex_);
  vehicle_->step(outputs, dt);
  const Moment moment{past_[newest_].motion_s + dt, vehicle_->truth()};
  newest_ = (newest_ + 1) % kept_moments;
  if (newest_ == past_.size()) {
    past_.push_back(moment);
  } else {
    past_[newest_] = moment;
  }
  keep_beside(now);
}

void SteeredTrajectory::keep_beside(Stamp now) {
  const Stamp in_step = now - measurement::from_seconds(past_[newest_].motion_s);
  if (!std::exchange(began_, true)) begin_ = in_step;
  if (in_step - begin_ > largest_lead) ++waits_;
  if (begin_ - in_step > largest_lead) ++jumps_;
  if (in_step - begin_ > largest_lead || begin_ - in_step > largest_lead) begin_ = in_step;
}

const SteeredTrajectory::Moment& SteeredTrajectory::moment(std::size_t age) const {
  return past_[(newest_ + past_.size() - age) % past_.size()];
}

Truth SteeredTrajectory::at(Stamp time) const {
  const std::lock_guard lock(mutex_);
  const double asked = began_ ? measurement::seconds(time - begin_) : 0;
  std::size_t age = 0;
  while (age + 1 < past_.size() && moment(age).motion_s > asked) ++age;
  Truth truth = moment(age).truth;
  const double from = moment(age).motion_s;
  if (age > 0 && asked > from)
    truth =
        between(truth, moment(age - 1).truth, (asked - from) / (moment(age - 1).motion_s - from));
  truth.at = time;
  return truth;
}

Truth SteeredTrajectory::latest() const {
  const std::lock_guard lock(mutex_);
  return past_[newest_].truth;
}

double SteeredTrajectory::motion_s() const {
  const std::lock_guard lock(mutex_);
  return past_[newest_].motion_s;
}

std::uint64_t SteeredTrajectory::waits() const {
  const std::lock_guard lock(mutex_);
  return waits_;
}

std::uint64_t SteeredTrajectory::jumps() const {
  const std::lock_guard lock(mutex_);
  return jumps_;
}

}  // namespace drydock::motion
