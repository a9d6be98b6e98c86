#include "hil/scorecard/run_record.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/geodetic.hpp"
#include "estimators/host/diagnostician.hpp"
#include "estimators/host/sound_devices.hpp"
#include "hil/bench/lockstep_bench.hpp"
#include "hil/motion/kept_trajectory.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::scorecard {
namespace {

using measurement::Stamp;

double sigmas_of(const Eigen::Vector2d& error, const Eigen::Matrix2d& covariance) {
  return error.cwiseAbs().cwiseQuotient(covariance.diagonal().cwiseSqrt()).maxCoeff();
}

/// A motion that takes orders is another one in each run.
std::shared_ptr<const motion::Trajectory> motion_of(const rig_config::Rig& rig) {
  auto motion = motion::make_trajectory(rig.mission, measurement::stamp_from_ns(rig.start_utc_ns));
  if (rig.mission.steering)
    return std::make_shared<motion::RememberedTrajectory>(std::move(motion));
  return std::make_shared<motion::KeptTrajectory>(std::move(motion));
}

}  // namespace

class Recording::Recorder final : private host::Follower {
 public:
  Recorder(const rig_config::Rig& rig, std::shared_ptr<const motion::Trajectory> motion)
      : start_(measurement::stamp_from_ns(rig.start_utc_ns)),
        shared_motion_(std::move(motion)),
        motion_(*shared_motion_),
        has_truth_(summary::truth_for_estimators(rig)),
        diagnostician_(rig, *this),
        bench_(rig, motion_, *this),
        sound_devices_(rig, bench_.pipeline()) {
    record_.devices.resize(rig.devices.size());
    record_.estimators.resize(rig.estimators.size());
    std::vector<const device::Device*> devices;
    for (std::size_t i = 0; i < bench_.devices(); ++i) devices.push_back(&bench_.device(i));
    diagnostician_.watch(std::move(devices));
  }

  void look_until(std::size_t last) {
    while (looks_ < last) {
      ++looks_;
      bench_.run_until(start_ + measurement::from_seconds(static_cast<double>(looks_) * poll_s));
      look();
    }
  }

  void set(rig_config::FaultConfig fault) {
    fault.start_s -= since_start(bench_.now());
    bench_.set_fault(fault);
  }

  void make_room(const RunRecord& of_like_run) {
    for (std::size_t i = 0; i < record_.devices.size(); ++i) {
      auto& device = record_.devices[i];
      const auto& like = of_like_run.devices.at(i);
      for (auto& [key, series] : device.series)
        if (const auto other = like.series.find(key); other != like.series.end())
          series.samples.reserve(other->second.samples.size());
      device.arrivals.reserve(like.arrivals.size());
      device.looks.reserve(like.looks.size());
    }
    for (std::size_t i = 0; i < record_.estimators.size(); ++i)
      record_.estimators[i].reserve(of_like_run.estimators.at(i).size());
  }

  RunRecord finish() {
    bench_.flush();
    return std::move(record_);
  }

  const std::shared_ptr<const motion::Trajectory>& motion() const { return shared_motion_; }

 private:
  double since_start(Stamp at) const { return measurement::seconds(at - start_); }

  void look() {
    diagnostician_.look(bench_.now());
    std::uint64_t rejected = 0, not_running = 0;
    const auto& pipeline = bench_.pipeline();
    for (std::size_t i = 0; i < pipeline.estimators(); ++i) {
      rejected += pipeline.status(i).rejected;
      not_running += pipeline.status(i).state == pipeline::EstimatorState::running ? 0 : 1;
    }
    for (std::size_t i = 0; i < bench_.devices(); ++i) {
      const auto health = bench_.device(i).health(bench_.now());
      Look look{.at_s = since_start(bench_.now()),
                .bad_checksums = health.stream.bad_checksums,
                .skipped = health.stream.bytes_skipped,
                .error_frames = health.error_frames,
                .trouble = health.last_error,
                .rate_hz = health.rate_hz,
                .rejected = rejected,
                .not_running = not_running};
      if (i < pipeline.counters().size()) {
        look.late = pipeline.counters()[i].late;
        look.refused = pipeline.counters()[i].refused;
      }
      record_.devices[i].looks.push_back(look);
    }
  }

  void on_finding(const diagnosis::Finding& finding) override {
    sound_devices_.on_finding(finding);
    auto& found = record_.findings;
    if (!finding.until) {
      found.push_back({finding.device,
                       finding.cause,
                       since_start(finding.since),
                       since_start(finding.found),
                       {}});
      return;
    }
    for (FindingAt& one : found)
      if (one.device == finding.device && !one.until_s) one.until_s = since_start(*finding.until);
  }

  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    diagnostician_.on_frame(link, way, frame, at);
  }

  void on_measurement(const measurement::Measurement& m) override {
    diagnostician_.on_measurement(m);
    const auto& origin = measurement::origin_of(m);
    auto& device = record_.devices.at(origin.device);
    Arrival arrival{since_start(origin.received_at), m.index(), 0};
    fields_of(m, start_, fields_);
    for (const Field& field : fields_) {
      auto& series = device.series[field.series];
      series.name = field.name;
      series.role = field.role;
      series.angle = field.angle;
      series.samples.push_back(
          {since_start(origin.valid_at), arrival.received_s, field.value, device.arrivals.size()});
      if (field.series < 64) arrival.fields |= std::uint64_t{1} << field.series;
    }
    device.arrivals.push_back(arrival);
  }

  void on_state(const device::Device& device, const device::Transition& change) override {
    record_.devices.at(device.index()).changes.push_back({since_start(change.at), change.to});
  }

  void on_estimate(const host::Estimate& told) override {
    if (!has_truth_) return;
    const bus::Attitude& estimate = told.attitude;
    const motion::Truth truth = motion_.at(estimate.valid_at);
    const Eigen::Vector2d off{
        std::remainder(estimate.roll_rad - truth.roll_rad, 2 * std::numbers::pi),
        std::remainder(estimate.pitch_rad - truth.pitch_rad, 2 * std::numbers::pi)};
    ErrorAt error{since_start(estimate.valid_at),
                  off.norm() * units::degrees_per_radian,
                  off.dot(estimate.covariance.inverse() * off) / 2,
                  {},
                  told.integrity.valid,
                  sigmas_of(off, estimate.covariance)};
    if (const auto& n = told.navigation) {
      const Eigen::Vector2d away =
          frame::ned_offset({truth.latitude_rad, truth.longitude_rad, truth.height_m},
                            {n->latitude_rad, n->longitude_rad, n->height_m})
              .head<2>();
      error.horizontal_m = away.norm();
      error.sigmas = std::max(error.sigmas, sigmas_of(away, n->covariance.topLeftCorner<2, 2>()));
    }
    record_.estimators.at(told.estimator).push_back(error);
  }

  Stamp start_;
  std::shared_ptr<const motion::Trajectory> shared_motion_;
  const motion::Trajectory& motion_;
  bool has_truth_;
  RunRecord record_;
  std::vector<Field> fields_;
  host::Diagnostician diagnostician_;
  bench::LockstepBench bench_;
  host::SoundDevices sound_devices_;
  std::size_t looks_ = 0;
};

Recording::Recording(const rig_config::Rig& rig)
    : recorder_(std::make_unique<Recorder>(rig, motion_of(rig))) {}
Recording::Recording(const rig_config::Rig& rig, const Recording& of_same_motion)
    : recorder_(std::make_unique<Recorder>(
          rig, rig.mission.steering ? motion_of(rig) : of_same_motion.recorder_->motion())) {}
Recording::~Recording() = default;

void Recording::run_before(double time_s) {
  const double looks = std::ceil(time_s / poll_s - 0.5) - 1;
  if (looks > 0) recorder_->look_until(static_cast<std::size_t>(looks));
}

void Recording::make_room(const RunRecord& of_like_run) { recorder_->make_room(of_like_run); }

void Recording::set(const rig_config::FaultConfig& fault) { recorder_->set(fault); }

RunRecord Recording::run_to(double end_s) {
  recorder_->look_until(static_cast<std::size_t>(std::ceil(end_s / poll_s)));
  return recorder_->finish();
}

RunRecord record_run(const rig_config::Rig& rig, double duration_s) {
  return Recording(rig).run_to(duration_s);
}

}  // namespace drydock::scorecard
