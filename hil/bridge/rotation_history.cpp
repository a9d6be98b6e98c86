#include "hil/bridge/rotation_history.hpp"

#include <algorithm>

namespace drydock::bridge {

namespace {

constexpr std::chrono::seconds kept{2};
constexpr std::chrono::milliseconds longest_gap{200};  ///< between samples, and behind the last one

/// The rotation by this rate for this time.
Eigen::Quaterniond turned_by(const Eigen::Vector3d& rate_radps, std::chrono::nanoseconds time) {
  const Eigen::Vector3d angle = rate_radps * measurement::seconds(time);
  const double size = angle.norm();
  if (size == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(size, angle / size));
}

}  // namespace

void RotationHistory::add(const measurement::ImuSample& sample) {
  const Stamp at = sample.origin.valid_at;
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  if (!turned_.empty()) {
    const Turned& last = turned_.back();
    if (at <= last.at) return;
    if (at - last.at > longest_gap) {
      turned_.clear();
    } else {
      const Eigen::Vector3d mean = 0.5 * (last.rate_radps + sample.angular_rate);
      attitude = (last.attitude * turned_by(mean, at - last.at)).normalized();
    }
  }
  turned_.push_back({at, attitude, sample.angular_rate});
  while (at - turned_.front().at > kept) turned_.pop_front();
}

std::optional<Eigen::Quaterniond> RotationHistory::attitude_at(Stamp at) const {
  const auto after = std::find_if(turned_.begin(), turned_.end(),
                                  [at](const Turned& turned) { return turned.at > at; });
  if (after == turned_.begin()) return {};  // older than all, or there are none
  const Turned& before = *std::prev(after);
  if (at - before.at > longest_gap) return {};
  if (after == turned_.end()) return before.attitude * turned_by(before.rate_radps, at - before.at);
  const double share =
      measurement::seconds(at - before.at) / measurement::seconds(after->at - before.at);
  return before.attitude.slerp(share, after->attitude);
}

std::optional<Eigen::Quaterniond> RotationHistory::between(Stamp from, Stamp to) const {
  const auto then = attitude_at(from), now = attitude_at(to);
  if (!then || !now) return {};
  return then->conjugate() * *now;
}

}  // namespace drydock::bridge
