#pragma once

#include <map>
#include <string>
#include <vector>

#include "hil/bench/run.hpp"
#include "hil/fault/schedule/random_faults.hpp"

namespace drydock::endurance {

/// Puts random faults on a run and keeps watch over its devices, second by second.
class SoakWatch {
 public:
  SoakWatch(const rig_config::Rig& rig, std::uint64_t seed, double fault_interval_s);

  void look(const bench::RunView& run);
  void note(const measurement::Measurement& measurement);

  /// Sentences, the first hundred of each kind of trouble; empty: all is well.
  const std::vector<std::string>& troubles() const { return troubles_; }
  std::uint64_t faults_set() const { return faults_set_; }
  const std::map<std::string, std::uint64_t>& set_by_word() const { return by_word_; }
  std::uint64_t looks() const { return looks_; }

 private:
  /// After its last fault a device has so long to stream again: an attempt to open comes each
  /// second, a node that was silent is forgotten after 10 s, a receiver looks for its satellites.
  static constexpr std::chrono::seconds recovers_within{120};

  void set_faults(const bench::RunView& run);
  void look_at(std::size_t index, const bench::RunView& run);
  void add(std::string trouble);

  const rig_config::Rig& rig_;
  fault::RandomFaults faults_;
  rig_config::FaultConfig next_;
  measurement::Stamp start_;
  std::vector<measurement::Stamp> trouble_until_;  ///< by device: its faults explain it so long
  std::uint64_t faults_set_ = 0, looks_ = 0;
  std::map<std::string, std::uint64_t> by_word_;
  std::vector<std::string> troubles_;
};

}  // namespace drydock::endurance
