#pragma once

#include <cstdint>
#include <vector>

#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"
#include "hil/summary/error_statistics.hpp"
#include "hil/summary/navigation_record.hpp"
#include "hil/summary/rate_count.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/rig.hpp"

namespace drydock::summary {

/// Follows a run: compares estimates with the truth and keeps curves with fewer points for the
/// report.
class Scribe final : public host::Follower {
 public:
  /// `truth` may be null (real sensors only) and must outlive the scribe. A curve has at most about
  /// `points_per_curve` points in the expected duration.
  Scribe(const rig_config::Rig& rig, const motion::Trajectory* truth, measurement::Stamp start,
         double expected_duration_s, double points_per_curve = 1500);

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_estimate(const host::Estimate& estimate) override;
  void on_clock_step(std::chrono::nanoseconds step) override { stepped_ += step; }
  /// Stores the true motion and the memory of this process. Call it at least as often as the curves
  /// have points.
  void tick(measurement::Stamp now) override;

  /// Fills in the estimators and all curves of the summary.
  void write(Summary& summary) const;

 private:
  struct Estimator {
    EstimatorSummary summary;
    ErrorStatistics whole_run, after_10_s;
    AttitudeTrace trace;
    NavigationRecord navigation;
    RateCount rate;
    bool has_truth = false;
    double next_point_s = 0;
  };
  struct Curve {
    std::size_t plot = 0;
    std::size_t line = 0;
    double next_point_s = 0;
  };

  void compare(Estimator& e, const bus::Attitude& estimate, const motion::Truth* truth, bool draw);
  bool is_time_to_draw(Estimator& e, double t_s) const;
  /// A message's time in the time of the start, which no step of the host's clock changes.
  measurement::Stamp steady(measurement::Stamp at) const { return at - stepped_; }
  double since_start(measurement::Stamp at) const { return measurement::seconds(at - start_); }
  void point(std::size_t curve, measurement::Stamp at, double value);
  std::size_t add_plot(const rig_config::DeviceConfig& device, const std::string& what,
                       std::string unit, std::vector<std::string> labels);
  void add_device(const rig_config::DeviceConfig& device);

  void follow_motion(measurement::Stamp now);

  const motion::Trajectory* truth_;
  measurement::Stamp start_;
  std::chrono::nanoseconds stepped_{0};
  double spacing_s_;
  std::vector<Estimator> estimators_;
  std::vector<MeasurementTrace> plots_;
  std::vector<Curve> curves_;
  std::vector<std::size_t> first_curve_;   ///< per device
  std::optional<frame::Position> origin_;  ///< origin of the axes in which the motion is drawn
  MotionTrace motion_;
  ResidentTrace resident_;
};

}  // namespace drydock::summary
