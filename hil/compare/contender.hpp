#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "estimators/host/bus_estimates.hpp"
#include "estimators/host/sound_devices.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/compare/comparison.hpp"
#include "hil/compare/stopwatch.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::compare {

/// One estimator with a pipeline of its own, so that its processor time is its own too.
class Contender final : private host::Follower {
 public:
  struct Setting {
    const motion::Trajectory* truth = nullptr;  ///< null: no errors are known
    measurement::Stamp start{};
    double expected_s = 0;  ///< for the spacing of curves
  };

  /// `rig` has one estimator. Throws std::runtime_error with one line if it cannot be made.
  Contender(std::string choice, rig_config::Rig rig, const Setting& setting);

  void take(const measurement::Measurement& measurement);
  void heed(const diagnosis::Finding& finding) { sound_devices_.on_finding(finding); }
  void finish();  ///< at the end of the run, once
  Entry entry() const;

 private:
  using Output = std::variant<pipeline::AttitudeEstimate, pipeline::NavigationEstimate>;

  /// Keeps what comes out until the stopwatch stands.
  class Outputs final : public pipeline::EstimateListener {
   public:
    void on_attitude(const pipeline::AttitudeEstimate& e) override { all.emplace_back(e); }
    void on_navigation(const pipeline::NavigationEstimate& e) override { all.emplace_back(e); }
    std::vector<Output> all;
  };

  void on_estimate(const host::Estimate& estimate) override;
  void pass_on();

  std::string choice_;
  rig_config::Rig rig_;
  Outputs outputs_;
  pipeline::Pipeline pipeline_;
  host::SoundDevices sound_devices_;
  host::EstimateTeller teller_;
  summary::Scribe scribe_;
  Stopwatch stopwatch_;
  std::vector<measurement::Stamp> valid_at_;
  std::vector<frame::Position> places_;
  measurement::Stamp::duration place_spacing_;
  measurement::Stamp next_place_ = measurement::Stamp::min();
};

}  // namespace drydock::compare
