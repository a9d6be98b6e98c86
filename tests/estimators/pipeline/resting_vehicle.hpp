#pragma once

#include <array>
#include <functional>
#include <optional>
#include <random>

#include "drivers/measurement/measurement.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/geodetic.hpp"
#include "estimators/frame/local_earth.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "rig_config/load.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline::test {

struct Navigated final : EstimateListener {
  void on_attitude(const AttitudeEstimate&) override {}
  void on_navigation(const NavigationEstimate& estimate) override { all.push_back(estimate); }
  void on_innovation(const InnovationReport& report) override {
    InnovationCount& of = innovations[report.device];
    ++of.reports;
    for (const auto& row : report.rows) {
      ++(row.used ? of.used : of.refused);
      if (row.used) of.squares += row.normalised_square();
    }
    of.last = report;
  }
  struct InnovationCount {
    std::uint64_t reports = 0, used = 0, refused = 0;  ///< rows
    double squares = 0;                                ///< of the used rows, normalised
    InnovationReport last;
  };
  std::vector<NavigationEstimate> all;
  std::array<InnovationCount, 10> innovations{};  ///< by device
};

/// A level vehicle in still water, at rest or turning about the vertical, with sensors without
/// noise: IMU 100 Hz (device 3), log 2 Hz (5), DVL 1 Hz (6), depth 10 Hz (7), actuators (8), GNSS
/// (9).
class RestingVehicle {
 public:
  explicit RestingVehicle(
      InertialMethod method, const std::function<void(InertialOptions&)>& change = [](auto&) {},
      milliseconds window = milliseconds{100}) {
    PipelineOptions all;
    EstimatorOptions& estimator = all.estimators.emplace_back();
    estimator.name = "n";
    estimator.imu = imu_device;
    options.method = method;
    options.start = {position(), Eigen::Vector3d::Zero(), attitude()};
    options.navigation.gate_sigma = 5;
    options.ground = AidingSensor{.device = 6};
    options.depth = AidingSensor{.device = 7};
    if (method == InertialMethod::sensors) {
      options.gnss = AidingSensor{.device = 9};
    } else {
      options.log = AidingSensor{.device = log_device};
      options.actuators = 8;
      options.vehicle = vehicle::dimensional(
          rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml")
              .value());
    }
    change(options);
    estimator.kind = options;
    all.reorder_window = window;
    pipeline.emplace(*make_pipeline(all, listener));
  }

  frame::Position position() const { return {0.6, 2.2, -20}; }
  Eigen::Quaterniond attitude() const {
    return Eigen::AngleAxisd(0.8 + turned_, Eigen::Vector3d::UnitZ()) *
           Eigen::Quaterniond::Identity();
  }
  const NavigationEstimate& last() const { return listener.all.back(); }
  Eigen::Vector3d offset() const { return frame::ned_offset(position(), last().position); }

  void run(double seconds) {
    for (long i = std::lround(100 * seconds); i > 0; --i) sample();
  }
  void skip(double seconds) {
    now += measurement::from_seconds(seconds);
    turned_ += turn_radps * seconds;
    tick_ += std::lround(100 * seconds);
  }

  InertialOptions options;
  Navigated listener;
  std::optional<Pipeline> pipeline;
  Stamp now = at_ms(0);
  double turn_radps = 0;
  Eigen::Vector3d dvl_error = Eigen::Vector3d::Zero();
  double depth_error_m = 0, log_error_mps = 0;
  Eigen::Vector3d rate_error = Eigen::Vector3d::Zero(), force_error = Eigen::Vector3d::Zero();
  double rate_noise_radps = 0;  ///< of each sample

  /// The commanded speed that the propeller's rate stands for, m/s, told from now on.
  std::optional<double> propeller_mps;

 private:
  template <class Measurement>
  void send(Measurement measurement, std::uint16_t device) {
    measurement.origin.valid_at = measurement.origin.received_at = now;
    measurement.origin.device = device;
    pipeline->receive(measurement);
  }

  void sample() {
    const Eigen::Quaterniond to_body = attitude().conjugate();
    const auto earth = frame::local_earth(position().latitude_rad, position().height_m);
    const Eigen::Vector3d turning{0, 0, turn_radps};
    measurement::ImuSample imu;
    imu.angular_rate = to_body * frame::earth_rate_ned(position().latitude_rad) + turning;
    imu.specific_force = to_body * Eigen::Vector3d{0, 0, -earth.gravity_mps2} +
                         imu.angular_rate.cross(imu.angular_rate.cross(options.imu_lever)) +
                         force_error;
    imu.angular_rate += rate_error;
    if (rate_noise_radps > 0)
      for (double& rate : imu.angular_rate) rate += rate_noise_radps * normal_(random_);
    send(imu, imu_device);
    if (tick_ % 10 == 0 && propeller_mps) {
      measurement::ActuatorState state;
      state.propeller_radps = *propeller_mps / options.advance_m;
      send(state, 8);
    }
    if (tick_ % 10 == 0) {
      measurement::DepthSample depth;
      const Eigen::Vector3d arm = options.depth->lever;
      depth.depth_m = -position().height_m + arm.z() + depth_error_m;
      send(depth, 7);
    }
    if (tick_ % 50 == 0 && options.log) {
      measurement::WaterSpeed speed;
      speed.longitudinal_mps = turning.cross(options.log->lever).x() + log_error_mps;
      send(speed, log_device);
    }
    if (tick_ % 100 == 0) {
      measurement::BottomVelocity track;
      track.velocity = turning.cross(options.ground->lever) + dvl_error;
      send(track, 6);
    }
    now += milliseconds{10};
    turned_ += turn_radps * 0.01;
    ++tick_;
  }

  double turned_ = 0;
  long tick_ = 0;
  std::mt19937_64 random_{8};
  std::normal_distribution<double> normal_;
};

}  // namespace drydock::pipeline::test
