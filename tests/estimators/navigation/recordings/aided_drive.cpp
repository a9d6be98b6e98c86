#include "tests/estimators/navigation/recordings/aided_drive.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::navigation::test {

using Eigen::Vector3d;

namespace {

constexpr double resting_mps = 0.05, moving_mps = 2, needed_rest_s = 5;
constexpr int rtk_fixed = 1;  // in RTKLIB; the error of a float solution exceeds its stated sigma

/// The IMU in body axes, in the time of the fixes, without its rate at rest.
struct Imu {
  const DriveRecording& drive;
  const DriveSetup& setup;
  Vector3d rest_rate = Vector3d::Zero();

  double time(std::size_t i) const { return drive.imu[i].t - setup.imu_delay_s; }
  Vector3d rate(std::size_t i) const { return setup.imu_to_body * drive.imu[i].rate - rest_rate; }
  Vector3d missed(const Vector3d& sigma) const {
    return (setup.imu_to_body.cwiseAbs2() * sigma.cwiseAbs2()).cwiseSqrt();
  }
  Vector3d force(std::size_t i) const { return setup.imu_to_body * drive.imu[i].force; }
};

double speed(const RtkFix& fix) { return fix.velocity_ned.head<2>().norm(); }

struct Start {
  std::size_t fix, sample;
  NavigationState state;
};

Read<Start> align(Imu& imu) {
  const auto& fixes = imu.drive.fixes;
  const auto leaves = std::find_if(fixes.begin(), fixes.end(),
                                   [](const RtkFix& f) { return speed(f) > resting_mps; });
  const auto moves =
      std::find_if(leaves, fixes.end(), [](const RtkFix& f) { return speed(f) > moving_mps; });
  if (moves == fixes.end()) return Refusal{"alignment", "the drive never reaches 2 m/s"};

  Vector3d force = Vector3d::Zero(), rate = Vector3d::Zero();
  std::size_t i = 1, first = 0;
  for (; i < imu.drive.imu.size() && imu.time(i) < leaves->t - 1; ++i) {
    if (imu.time(i) < fixes.front().t) continue;
    if (!first) first = i;
    force += imu.force(i);
    rate += imu.rate(i);
  }
  if (!first || imu.time(i) - imu.time(first) < needed_rest_s)
    return Refusal{"alignment", "the drive does not begin with 5 s of rest"};
  imu.rest_rate = rate / static_cast<double>(i - first);
  const double roll = std::atan2(-force.y(), -force.z());
  const double pitch = std::atan2(force.x(), std::hypot(force.y(), force.z()));
  Eigen::Quaterniond attitude = frame::body_to_ned({roll, pitch, 0});
  for (; i < imu.drive.imu.size() && imu.time(i) <= moves->t; ++i)
    attitude = attitude * quaternion_of(imu.rate(i) * (imu.time(i) - imu.time(i - 1)));
  frame::Euler at = frame::euler(attitude);
  at.yaw = std::atan2(moves->velocity_ned.y(), moves->velocity_ned.x());
  return Start{static_cast<std::size_t>(moves - fixes.begin()),
               i,
               {moves->position, moves->velocity_ned, frame::body_to_ned(at)}};
}

Eigen::Vector2d horizontal_error(const AidedNavigation& aided, const RtkFix& fix,
                                 const Vector3d& antenna) {
  const NavigationState& now = aided.state();
  return (frame::ned_offset(fix.position, now.position) + now.body_to_ned * antenna).head<2>();
}

}  // namespace

Read<AlignedDrive> aligned(const DriveRecording& drive, const DriveSetup& setup) {
  Imu imu{drive, setup};
  const auto start = align(imu);
  if (start.has_error()) return start.error();
  AlignedDrive made{start->fix, start->state, {}};
  for (std::size_t i = start->sample - 1; i < drive.imu.size(); ++i)
    made.imu.push_back({imu.time(i), imu.rate(i), imu.force(i)});
  return made;
}

Read<DriveResult> navigate(const DriveRecording& drive, const DriveSetup& setup, const Gaps& gaps) {
  Imu imu{drive, setup};
  const auto start = align(imu);
  if (start.has_error()) return start.error();
  AidedNavigation aided{start->state, setup.options};
  const double begin = drive.fixes[start->fix].t;
  const auto in_gap = [&](double t) {
    return std::fmod(t - begin + gaps.early_s, gaps.every_s) >= gaps.every_s - gaps.length_s;
  };

  DriveResult result;
  bool after_gap = false;
  double now = begin, square = 0, nis = 0;
  std::size_t aids = 0, rows = 0, sample = start->sample;
  const auto go_to = [&](double t) {  // uses part of a sample if a fix lies inside it
    const double dt = t - now;
    aided.add_imu(imu.rate(sample) * dt, imu.force(sample) * dt, dt);
    aided.step();
    now = t;
  };
  for (std::size_t i = start->fix + 1; i < drive.fixes.size(); ++i) {
    const RtkFix& fix = drive.fixes[i];
    for (; sample < drive.imu.size() && imu.time(sample) <= fix.t; ++sample) {
      const ImuRow& row = drive.imu[sample];
      const double dt = imu.time(sample) - imu.time(sample - 1);
      if (!row.rate_missed.isZero())
        aided.add_noise(imu.missed(row.rate_missed) * dt, imu.missed(row.force_missed) * dt);
      go_to(imu.time(sample));
    }
    if (sample == drive.imu.size()) break;
    go_to(fix.t);
    const Eigen::Vector2d error = horizontal_error(aided, fix, setup.antenna);
    if (in_gap(fix.t)) {
      if (i + 1 < drive.fixes.size() && in_gap(drive.fixes[i + 1].t)) continue;
      result.gap_end_m.push_back(error.norm());
      const auto& p = aided.covariance();
      const Eigen::Vector2d metres{6.37e6, 6.37e6 * std::cos(fix.position.latitude_rad)};
      const Eigen::Matrix2d expected =
          metres.asDiagonal() * p.topLeftCorner<2, 2>() * metres.asDiagonal();
      result.gap_sigma_m.push_back(std::sqrt(expected.trace()));
      result.gap_nees.push_back(error.dot(expected.ldlt().solve(error)) / 2);
      after_gap = true;
      continue;
    }
    if (fix.quality != rtk_fixed) continue;
    if (!after_gap) square += error.squaredNorm(), ++aids;
    after_gap = false;
    const Vector3d sigma =
        (fix.sigma_m.array().square() + setup.fix_sigma_m * setup.fix_sigma_m).sqrt();
    aided.update_position(fix.position, sigma, setup.antenna);
    nis += aided.innovation_square();
    rows += aided.innovations().size();
  }
  if (aids == 0) return Refusal{"alignment", "no fix while the IMU runs"};
  result.aided_rms_m = std::sqrt(square / static_cast<double>(aids));
  result.nis = nis / static_cast<double>(rows);
  return result;
}

}  // namespace drydock::navigation::test
