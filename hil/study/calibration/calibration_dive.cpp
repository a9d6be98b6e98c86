#include "hil/study/calibration/calibration_dive.hpp"

#include <memory>

#include "drivers/measurement/units.hpp"
#include "estimators/smoothing/level_smoother.hpp"
#include "estimators/smoothing/tilt_smoother.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/study/campaign.hpp"

namespace drydock::study {
namespace {

using Eigen::Vector3d;
using rig_config::LegKind;
using smoothing::Quantity;

constexpr double period_s = 2;
constexpr double dvl_noise_mps = 0.01, heading_noise_rad = 0.3 * units::degree;
constexpr double tilt_noise_rad = 0.1 * units::degree, depth_noise_m = 0.05, fix_noise_m = 1;
const Vector3d dvl_lever{0.8, 0, 0.35}, depth_lever{-0.5, 0, 0.1}, antenna_lever{0.2, 0, -0.6};

/// One sigma of the drawn errors, in the order of parameters_of().
constexpr std::array drawn_sigma{2 * units::degree, 1 * units::degree, 0.015, 0.1, 0.3, 0.3,
                                 1 * units::degree, 1 * units::degree, 0.1,   0.1};

rig_config::LegConfig leg(LegKind kind, double duration_s, double amount = 0, double speed = 0) {
  rig_config::LegConfig leg;
  leg.kind = kind;
  leg.duration_s = duration_s;
  leg.speed_mps = speed;
  if (kind == LegKind::turn) leg.turn_rad = amount * units::degree;
  if (kind == LegKind::dive) leg.depth_change_m = amount;
  return leg;
}

rig_config::MissionConfig calibration_mission() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * units::degree;
  mission.longitude_rad = 129 * units::degree;
  mission.heading_rad = 30 * units::degree;
  mission.speed_mps = 1.5;
  using enum LegKind;
  mission.legs = {leg(straight, 60, 0, 1.5), leg(turn, 200, 360, 1.5),  leg(dive, 80, 20, 1.5),
                  leg(turn, 30, 90, 1.5),    leg(straight, 60, 0, 2.5), leg(turn, 30, -120, 2.5),
                  leg(straight, 80, 0, 2.5), leg(turn, 30, -90, 2.5),   leg(straight, 60, 0, 1),
                  leg(turn, 40, -90, 1),     leg(dive, 80, -20, 1.5),   leg(straight, 60, 0, 1.5),
                  leg(turn, 120, -180, 1.5), leg(straight, 60, 0, 1.5)};
  return mission;
}

/// The readings of one dive with the random numbers of its run.
class Emulated {
 public:
  Emulated(const CalibrationErrors& errors, std::uint64_t seed, std::size_t run)
      : random_(stream_of(seed, run, "noise")), bias_(errors.heading_bias_rad), models_(4) {
    models_[dvl_of_dive].lever = dvl_lever;
    for (std::size_t i = 0; i < errors.parameters.size(); ++i)
      calibration::apply(errors.parameters[i], errors.values[i], models_);
  }

  smoothing::Dive dive() {
    const auto& trajectory = calibration_trajectory();
    const double end = measurement::seconds(trajectory.end() - trajectory.start());
    for (int i = 0; i * period_s < end; ++i)
      sense(i * period_s,
            trajectory.at(trajectory.start() + measurement::from_seconds(i * period_s)));
    dive_.tilts = smoothing::smooth_tilts(std::move(dive_.tilts));
    return std::move(dive_);
  }

 private:
  double normal(double sigma) { return sigma * random_.normal(); }

  void sense(double t, const motion::Truth& truth) {
    dive_.tilts.push_back(
        {t, truth.roll_rad + normal(tilt_noise_rad), truth.pitch_rad + normal(tilt_noise_rad)});
    add(t + models_[compass_of_dive].latency_s, Quantity::heading, compass_of_dive,
        {heading(truth) + normal(heading_noise_rad), 0, 0}, heading_noise_rad);
    add(t + models_[depth_of_dive].latency_s, Quantity::depth, depth_of_dive,
        {sensor::depth_at(truth, {.lever_arm_m = depth_lever}) + normal(depth_noise_m), 0, 0},
        depth_noise_m);
    add(t + models_[dvl_of_dive].latency_s, Quantity::bottom, dvl_of_dive, track(truth),
        dvl_noise_mps);
    if (-truth.height_m < 0.3) add_fix(t, truth);
  }

  double heading(const motion::Truth& truth) const {
    const auto [a, b, c] = models_[compass_of_dive].deviation_rad;
    return truth.yaw_rad + bias_ + a + b * std::sin(truth.yaw_rad) + c * std::cos(truth.yaw_rad);
  }

  /// The mounting turns the body's axes by yaw, then pitch into those that the sensor really has.
  Vector3d track(const motion::Truth& truth) {
    const auto& model = models_[dvl_of_dive];
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(model.yaw_rad, Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(model.pitch_rad, Vector3d::UnitY()))
                                     .toRotationMatrix();
    const Vector3d ideal = sensor::velocity_at(truth, {turn, model.lever});
    return (1 + model.scale_error) * ideal +
           Vector3d{normal(dvl_noise_mps), normal(dvl_noise_mps), normal(dvl_noise_mps)};
  }

  void add_fix(double t, const motion::Truth& truth) {
    const auto antenna = sensor::place_of(truth, {.lever_arm_m = antenna_lever});
    const auto seen = frame::at_ned_offset(antenna, {normal(fix_noise_m), normal(fix_noise_m), 0});
    add(t, Quantity::fix, gnss_of_dive, {seen.latitude_rad, seen.longitude_rad, 0}, fix_noise_m);
  }

  void add(double t, Quantity quantity, std::uint16_t device, const Vector3d& value, double sigma) {
    dive_.readings.push_back({t, quantity, device, value, Vector3d::Constant(sigma)});
  }

  sensor::RandomStream random_;
  double bias_;
  smoothing::SensorModels models_;
  smoothing::Dive dive_;
};

/// The parameters of one DVL, one compass and one depth sensor, as parameters_of() has them.
std::vector<calibration::Parameter> calibration_parameters() {
  smoothing::Dive dive;
  dive.readings.resize(3);
  dive.readings[1].quantity = Quantity::heading;
  dive.readings[1].device = compass_of_dive;
  dive.readings[2].quantity = Quantity::depth;
  dive.readings[2].device = depth_of_dive;
  return calibration::parameters_of(dive);
}

}  // namespace

CalibrationErrors drawn_errors(std::uint64_t seed, std::size_t run) {
  CalibrationErrors errors{calibration_parameters(), {}, 0};
  auto random = stream_of(seed, run, "errors");
  for (const double sigma : drawn_sigma) errors.values.push_back(sigma * random.normal());
  return errors;
}

CalibrationErrors drawn_bias(std::uint64_t seed, std::size_t run) {
  return {{}, {}, 1 * units::degree * stream_of(seed, run, "bias").normal()};
}

const motion::Trajectory& calibration_trajectory() {
  static const auto trajectory = motion::make_trajectory(calibration_mission(), motion::Stamp{});
  return *trajectory;
}

smoothing::Dive calibration_dive(const CalibrationErrors& errors, std::uint64_t seed,
                                 std::size_t run) {
  return Emulated(errors, seed, run).dive();
}

smoothing::LevelOptions calibration_options(const smoothing::Dive& dive) {
  smoothing::LevelOptions options;
  options.start = smoothing::level_start(dive, {});
  options.sensors.resize(4);
  options.sensors[dvl_of_dive].lever = dvl_lever;
  options.sensors[depth_of_dive].lever = depth_lever;
  options.sensors[gnss_of_dive].lever = antenna_lever;
  options.sigmas.heading_bias_rad = 1 * units::degree;
  options.sigmas.current_mps = 0;
  options.motion.current_mps = 0;
  return options;
}

}  // namespace drydock::study
