#pragma once

#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "rig_config/fault.hpp"

namespace drydock::fault {

using measurement::Stamp;
using rig_config::FaultConfig;
using rig_config::FaultKind;

/// A fault that is in force.
struct InForce {
  const FaultConfig* fault = nullptr;
  Stamp since{};
  std::optional<Stamp> until;  ///< empty: until cleared
};

/// The last fault of this kind, which overrides earlier ones; null: none.
const InForce* find(const std::vector<InForce>& faults, FaultKind kind);

/// The faults of one device and their times. A fault is in force from its start until just before
/// its end. A fault that repeats is in force in each of its turns.
class Schedule {
 public:
  explicit Schedule(Stamp start) : start_(start) {}

  void add(const FaultConfig& fault);

  /// Sets a fault by hand; its start_s counts from `now`. It replaces earlier faults that were set
  /// by hand and are over, or have the same kind and quantity.
  void set(FaultConfig fault, Stamp now);

  /// Removes the faults of a kind, or all. Returns how many were in force or still to come.
  std::size_t clear(std::optional<FaultKind> kind = {});

  std::vector<InForce> in_force(Stamp at) const;
  std::size_t size() const { return faults_.size(); }   ///< in force, still to come, and over
  std::optional<Stamp> next_change(Stamp after) const;  ///< the next start or end
  std::uint64_t edits() const { return edits_; }        ///< number of changes by hand

 private:
  Stamp start_;
  std::vector<FaultConfig> faults_;
  std::uint64_t edits_ = 0;
};

}  // namespace drydock::fault
