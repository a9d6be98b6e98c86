#pragma once

#include <functional>
#include <map>
#include <memory>

#include "drivers/recordings/record/player.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/setup/outside.hpp"
#include "hil/replay/onto.hpp"
#include "hil/replay/pace.hpp"
#include "hil/replay/recorded_truth.hpp"
#include "hil/replay/replay_faults.hpp"
#include "hil/replay/truth_errors.hpp"

namespace drydock::replay {

/// What a replay moves besides drivers and estimators.
struct ReplayOutlets {
  /// Called after each measurement and estimate; false ends the replay. May be empty.
  std::function<bool(const terminal::InterruptFlag&)> step = {};
  Onto* onto = nullptr;               ///< may be null
  std::function<void()> at_end = {};  ///< before the devices close; may be empty
  /// How estimators in other programs are reached; null: they are not.
  const setup::Outside* outside = nullptr;
  /// By link: when what fed it ended. Other links go on to the end of the recording.
  std::map<std::string, measurement::Stamp> ends = {};
};

/// Drivers and estimators of a recorded rig, fed with the recorded bytes. Time is virtual, with or
/// without a pace: the results do not depend on the pace.
class ReplayBench {
 public:
  /// Throws std::runtime_error with one line. All arguments must outlive the bench.
  ReplayBench(record::Recording& recording, const rig_config::Rig& rig,
              const record::Selection& part, const ReplayOutlets& outlets,
              const std::vector<rig_config::FaultConfig>& faults = {});

  host::Followers& followers() { return followers_; }
  measurement::Stamp start() const { return start_; }

  /// Plays to the end of the part, or until Ctrl-C or the last step.
  void play(Pace& pace, const record::Watch& watch);

  std::uint64_t measurements() const { return gate_.measurements; }
  bool interrupted() const { return gate_.ended; }
  const std::vector<std::uint64_t>& estimates() const { return gate_.estimates; }  ///< by estimator
  const TruthErrors& errors() const { return errors_; }
  const record::Player& player() const { return *player_; }
  std::vector<const device::Device*> devices() const;            ///< in the order of the rig
  std::vector<std::pair<std::string, double>> rates_hz() const;  ///< now, by device
  const ReplayFaults* faults() const { return faults_.get(); }   ///< nullptr: none
  pipeline::Pipeline& pipeline() { return pipeline_; }
  measurement::Stamp::duration played() const { return player_->now() - start_; }

 private:
  using Stamp = measurement::Stamp;

  bool wait_until(Stamp at, Pace& pace);
  void add_faults(const std::vector<rig_config::FaultConfig>& faults);
  void play(const record::RawEvent& event);
  void hear(const record::Understood& message);
  void hear(const record::RawEvent& event);
  void tell_health();
  void skip_hole(Stamp at);
  void end_links_before(Stamp at);
  void note_heard(const record::Event& event, Stamp at);

  /// Counts results and passes them on until the replay ends.
  class Gate final : public host::Follower {
   public:
    Gate(ReplayBench& bench, std::size_t estimators) : estimates(estimators), bench_(bench) {}

    std::uint64_t measurements = 0;
    std::vector<std::uint64_t> estimates;
    bool ended = false;     ///< by the user: nothing is told any more
    bool stopping = false;  ///< the recording has ended: devices close

    void on_measurement(const measurement::Measurement& measurement) override;
    void on_state(const device::Device& device, const device::Transition& change) override;
    void on_estimate(const host::Estimate& estimate) override;
    void on_innovation(const bus::Innovation& innovation) override;

   private:
    void step();

    ReplayBench& bench_;
  };

  record::Recording& recording_;
  const rig_config::Rig& rig_;
  const record::Selection& part_;
  ReplayOutlets outlets_;
  terminal::InterruptFlag interrupt_;
  host::Followers followers_;
  Gate gate_;
  host::EstimateTeller teller_;
  pipeline::Pipeline pipeline_;
  Stamp start_, next_health_;
  std::optional<Stamp> heard_;        ///< the last message of the recording, of any kind
  std::vector<Stamp> heard_of_link_;  ///< by link; those after the last heard are missing
  bool has_health_ = false;           ///< the recording has the health that its run told
  std::unique_ptr<record::Player> player_;
  std::unique_ptr<ReplayFaults> faults_;
  TruthErrors errors_;
  RecordedTruth truth_{followers_};
};

}  // namespace drydock::replay
