#include "hil/replay/recorded_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/recordings/record/recording.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/replay/recorded_truth.hpp"

namespace drydock::replay {
namespace {

using motion::Truth;

struct Collector final : host::Follower {
  void on_truth(const host::Estimate& truth) override {
    if (truth.navigation) all.push_back(truth);
  }
  std::vector<host::Estimate> all;
};

Truth truth_of(const host::Estimate& estimate) {
  const auto& navigation = *estimate.navigation;
  Truth truth;
  truth.at = navigation.valid_at;
  truth.latitude_rad = navigation.latitude_rad;
  truth.longitude_rad = navigation.longitude_rad;
  truth.height_m = navigation.height_m;
  truth.body_to_ned = navigation.body_to_ned;
  truth.velocity_ned = navigation.velocity_ned;
  return truth;
}

/// The values that follow from attitude and velocity.
Truth complete(Truth truth) {
  const Eigen::Matrix3d to_body = truth.body_to_ned.toRotationMatrix().transpose();
  const auto angles = frame::euler(to_body);
  truth.roll_rad = angles.roll;
  truth.pitch_rad = angles.pitch;
  truth.yaw_rad = angles.yaw;
  truth.velocity_body = to_body * truth.velocity_ned;
  return truth;
}

Truth between(const Truth& a, const Truth& b, double part) {
  Truth truth = a;
  const double turn = std::remainder(b.longitude_rad - a.longitude_rad, 2 * std::numbers::pi);
  truth.latitude_rad += part * (b.latitude_rad - a.latitude_rad);
  truth.longitude_rad += part * turn;
  truth.height_m += part * (b.height_m - a.height_m);
  truth.velocity_ned += part * (b.velocity_ned - a.velocity_ned);
  truth.body_to_ned = a.body_to_ned.slerp(part, b.body_to_ned);
  return truth;
}

}  // namespace

std::unique_ptr<RecordedTrajectory> RecordedTrajectory::read(const std::string& file) {
  auto recording = record::Recording::open(file);
  if (!recording) return nullptr;
  Collector collector;
  RecordedTruth truth(collector);
  while (const auto event = recording->next())
    if (const auto* message = std::get_if<record::Understood>(&*event)) truth.hear(*message);
  truth.tell();
  if (collector.all.size() < 2) return nullptr;
  return std::make_unique<RecordedTrajectory>(collector.all);
}

RecordedTrajectory::RecordedTrajectory(const std::vector<host::Estimate>& truth) {
  truth_.reserve(truth.size());
  for (const auto& one : truth)
    if (truth_.empty() || one.navigation->valid_at > truth_.back().at)
      truth_.push_back(truth_of(one));
}

Truth RecordedTrajectory::at(measurement::Stamp time) const {
  const auto after = std::ranges::upper_bound(truth_, time, {}, &Truth::at);
  Truth truth;
  if (after == truth_.begin() || after == truth_.end()) {
    truth = after == truth_.begin() ? truth_.front() : truth_.back();
  } else {
    const Truth& before = *std::prev(after);
    truth = between(
        before, *after,
        measurement::seconds(time - before.at) / measurement::seconds(after->at - before.at));
  }
  truth.at = time;
  return complete(truth);
}

}  // namespace drydock::replay
