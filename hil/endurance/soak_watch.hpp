#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hil/bench/follower.hpp"
#include "hil/fault/schedule/random_faults.hpp"

namespace drydock::endurance {

/// Time with faults between two rests.
constexpr double burst_s = 300;

/// Sets random faults in a run and checks its devices every second.
class SoakWatch final : public bench::Follower {
 public:
  /// Without an interval it sets no faults. `rest_s` over 0: no fault begins for so long after each
  /// `burst_s`, and what is still found when the last one is long over is a false alarm.
  SoakWatch(const rig_config::Rig& rig, std::uint64_t seed, std::optional<double> fault_interval_s,
            double rest_s = 0);

  void on_start(const bench::BenchView& bench) override { bench_ = &bench; }
  bool hears_truth() const override { return false; }
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_finding(const diagnosis::Finding& finding) override;
  void tick(Stamp now) override;

  /// Sentences, at most a hundred. Empty if all is well.
  const std::vector<std::string>& troubles() const { return troubles_; }
  std::uint64_t faults_set() const { return faults_set_; }
  const std::map<std::string, std::uint64_t>& set_by_word() const { return by_word_; }
  std::uint64_t looks() const { return looks_; }
  std::uint64_t findings() const { return findings_; }
  /// Findings that began, or in a rest stayed, while no device had a fault, and none had had one
  /// for `recovers_within`.
  std::uint64_t false_alarms() const { return false_alarms_; }
  /// Findings of bottom lost and of satellites blocked: they may be true without a fault.
  std::uint64_t of_surroundings() const { return of_surroundings_; }
  double quiet_s() const { return quiet_s_; }  ///< time in which a finding is a false alarm

 private:
  /// Time that a device has to stream again after its last fault: it tries to open once a second, a
  /// silent node is forgotten after 10 s, and a receiver searches for its satellites.
  static constexpr std::chrono::seconds recovers_within{120};

  void take_next();
  void set_faults(Stamp now);
  void look_at_what_stays(Stamp now);
  void count_quiet(Stamp now);
  bool quiet(Stamp now) const { return now > fault_until_; }
  void look_at(std::size_t index, Stamp now);
  void add(std::string trouble);

  const rig_config::Rig& rig_;
  const bench::BenchView* bench_ = nullptr;
  std::optional<fault::RandomFaults> faults_;
  std::optional<rig_config::FaultConfig> next_;
  double rest_s_;
  struct Staying {
    diagnosis::Finding finding;
    bool told = false;
  };
  std::map<std::uint16_t, Staying> staying_;  ///< by device, while they last
  measurement::Stamp start_;
  std::vector<measurement::Stamp> trouble_until_;  ///< by device: until then its faults explain its
                                                   ///< state
  Stamp fault_until_, last_tick_;                  ///< until then some fault may still be seen
  std::uint64_t faults_set_ = 0, looks_ = 0, findings_ = 0, false_alarms_ = 0, of_surroundings_ = 0;
  double quiet_s_ = 0;
  std::map<std::string, std::uint64_t> by_word_;
  std::vector<std::string> troubles_;
};

}  // namespace drydock::endurance
