#pragma once

#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "rig_config/fault.hpp"

namespace drydock::fault {

using measurement::Stamp;
using rig_config::FaultConfig;
using rig_config::FaultKind;

/// A fault while it lasts.
struct InForce {
  const FaultConfig* fault = nullptr;
  Stamp since{};
  std::optional<Stamp> until;  ///< empty: until cleared
};

/// The last of a kind, which goes before the others; nullptr: none.
const InForce* find(const std::vector<InForce>& faults, FaultKind kind);

/// Which faults of one device are in force when. A fault holds from its start to just before its
/// end; one that comes again holds in each of its turns.
class Schedule {
 public:
  explicit Schedule(Stamp start) : start_(start) {}

  void add(const FaultConfig& fault);

  /// Sets one by hand: its start_s counts from `now`. It takes the place of those set by hand
  /// before that are over, or of the same kind and quantity.
  void set(FaultConfig fault, Stamp now);

  /// Takes out those of a kind, or all; how many were in force or still to come.
  std::size_t clear(std::optional<FaultKind> kind = {});

  std::vector<InForce> in_force(Stamp at) const;
  std::size_t size() const { return faults_.size(); }   ///< in force, to come, and over
  std::optional<Stamp> next_change(Stamp after) const;  ///< the next start or end
  std::uint64_t edits() const { return edits_; }        ///< how often it was set or cleared by hand

 private:
  Stamp start_;
  std::vector<FaultConfig> faults_;
  std::uint64_t edits_ = 0;
};

}  // namespace drydock::fault
