#pragma once

#include <memory>

#include "drivers/recordings/record/player.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/bench/run_watchers.hpp"
#include "hil/replay/onto.hpp"
#include "hil/replay/pace.hpp"
#include "hil/replay/replay_faults.hpp"
#include "hil/replay/replay_lines.hpp"
#include "hil/replay/truth_errors.hpp"

namespace drydock::replay {

/// Outputs of a replay besides drivers and estimators.
struct ReplayOutlets {
  ReplayLines* lines = nullptr;  ///< every member may be null
  Steps* steps = nullptr;
  Onto* onto = nullptr;
  std::FILE* states = nullptr;
};

/// Drivers and estimators of a recorded rig, fed with the recorded bytes. Time is virtual, with or
/// without a pace: the results do not depend on the pace.
class ReplayBench final : private device::Listener, private pipeline::EstimateListener {
 public:
  /// Throws std::runtime_error with one line. All arguments must outlive the bench.
  ReplayBench(record::Recording& recording, const rig_config::Rig& rig,
              const record::Selection& part, const ReplayOutlets& outlets,
              const std::vector<rig_config::FaultConfig>& faults = {});

  host::Watchers& watchers() { return watchers_.all; }

  /// Plays to the end of the part, or until Ctrl-C or the last step.
  void play(Pace& pace, const record::Watch& watch);

  std::uint64_t measurements() const { return measurements_; }
  bool interrupted() const { return ended_; }
  const std::vector<std::uint64_t>& estimates() const { return estimates_; }  ///< by estimator
  const TruthErrors& errors() const { return errors_; }
  const record::Player& player() const { return *player_; }
  const ReplayFaults* faults() const { return faults_.get(); }  ///< nullptr: none
  const pipeline::Pipeline& pipeline() const { return pipeline_; }
  measurement::Stamp::duration played() const { return player_->now() - start_; }

 private:
  using Stamp = measurement::Stamp;

  bool wait_until(Stamp at, Pace& pace);
  void add_faults(const std::vector<rig_config::FaultConfig>& faults);
  void play(const record::RawEvent& event);
  void hear(const record::Understood& message);
  void hear(const record::RawEvent& event);
  void tell_health();
  void shown();
  template <class Estimate>
  void pass_on(const Estimate& estimate);

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_state(const device::Device& device, const device::Transition& change) override;
  void on_attitude(const pipeline::AttitudeEstimate& estimate) override;
  void on_navigation(const pipeline::NavigationEstimate& estimate) override;
  void on_innovation(const pipeline::InnovationReport& report) override;

  record::Recording& recording_;
  const rig_config::Rig& rig_;
  const record::Selection& part_;
  ReplayOutlets outlets_;
  terminal::InterruptFlag interrupt_;
  bench::RunWatchers watchers_;
  pipeline::Pipeline pipeline_;
  Stamp start_, next_health_;
  std::unique_ptr<record::Player> player_;
  std::unique_ptr<ReplayFaults> faults_;
  TruthErrors errors_;
  std::uint64_t measurements_ = 0;
  std::vector<std::uint64_t> estimates_;
  bool ended_ = false, stopping_ = false;
};

}  // namespace drydock::replay
