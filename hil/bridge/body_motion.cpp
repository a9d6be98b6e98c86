#include "hil/bridge/body_motion.hpp"

namespace drydock::bridge {

namespace {

constexpr std::chrono::seconds longest_pause{1};

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

}  // namespace

std::optional<Moved> BodyMotion::add(Stamp at, const Eigen::Vector3d& velocity,
                                     const RotationHistory& rotation) {
  const auto before = last_at_;
  const Eigen::Vector3d velocity_before = last_velocity_;
  if (before && at <= *before) return {};
  last_at_ = at;
  last_velocity_ = velocity;
  if (!before || at - *before > longest_pause) {
    mark();
    return {};
  }
  const auto turn = rotation.between(*before, at);
  rotation_known_ = rotation_known_ && turn;
  const Eigen::Quaterniond to_now = turn ? turn->conjugate() : Eigen::Quaterniond::Identity();
  turned_ = turned_ * to_now.conjugate();
  position_m_ = to_now * position_m_ +
                0.5 * measurement::seconds(at - *before) * (to_now * velocity_before + velocity);
  return Moved{at, at - marked_at_, rotation_vector(turned_), position_m_, rotation_known_};
}

void BodyMotion::mark() {
  if (last_at_) marked_at_ = *last_at_;
  turned_ = Eigen::Quaterniond::Identity();
  position_m_.setZero();
  rotation_known_ = true;
}

}  // namespace drydock::bridge
