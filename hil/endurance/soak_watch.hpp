#pragma once

#include <map>
#include <string>
#include <vector>

#include "hil/bench/follower.hpp"
#include "hil/fault/schedule/random_faults.hpp"

namespace drydock::endurance {

/// Sets random faults in a run and checks its devices every second.
class SoakWatch final : public bench::Follower {
 public:
  SoakWatch(const rig_config::Rig& rig, std::uint64_t seed, double fault_interval_s);

  void on_start(const bench::BenchView& bench) override { bench_ = &bench; }
  void on_measurement(const measurement::Measurement& measurement) override;
  void tick(Stamp now) override;

  /// Sentences, at most a hundred. Empty if all is well.
  const std::vector<std::string>& troubles() const { return troubles_; }
  std::uint64_t faults_set() const { return faults_set_; }
  const std::map<std::string, std::uint64_t>& set_by_word() const { return by_word_; }
  std::uint64_t looks() const { return looks_; }

 private:
  /// Time that a device has to stream again after its last fault: it tries to open once a second, a
  /// silent node is forgotten after 10 s, and a receiver searches for its satellites.
  static constexpr std::chrono::seconds recovers_within{120};

  void set_faults(Stamp now);
  void look_at(std::size_t index, Stamp now);
  void add(std::string trouble);

  const rig_config::Rig& rig_;
  const bench::BenchView* bench_ = nullptr;
  fault::RandomFaults faults_;
  rig_config::FaultConfig next_;
  measurement::Stamp start_;
  std::vector<measurement::Stamp> trouble_until_;  ///< by device: until then its faults explain its
                                                   ///< state
  std::uint64_t faults_set_ = 0, looks_ = 0;
  std::map<std::string, std::uint64_t> by_word_;
  std::vector<std::string> troubles_;
};

}  // namespace drydock::endurance
