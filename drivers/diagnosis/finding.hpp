#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "drivers/diagnosis/cause.hpp"
#include "drivers/diagnosis/symptom.hpp"

namespace drydock::diagnosis {

/// One number that speaks for a finding: "yaw rate 31 deg/s, at most 12".
struct Evidence {
  Sign sign = Sign::silent;
  double value = 0, limit = 0;  ///< on the same side of zero
  std::string_view quantity, unit;
};

/// What is wrong with which device, since when, on what evidence.
struct Finding {
  std::uint16_t device = 0;  ///< index in the rig
  Cause cause = Cause::silent;
  Stamp since{};               ///< when it began
  Stamp found{};               ///< when it was known
  std::optional<Stamp> until;  ///< when it was over; empty: it lasts
  double confidence = 0;       ///< 0 to 1: how sure the word is; 1 - confidence is not the risk of
                               ///< a false alarm, which each monitor keeps by itself
  boost::container::static_vector<Evidence, 4> evidence;
  std::string_view advice;  ///< with static storage; empty: that of the cause
};

/// Hears findings when they begin, when their cause gets a better word, and when they are over.
class FindingListener {
 public:
  virtual ~FindingListener() = default;
  virtual void on_finding(const Finding& finding) = 0;
};

}  // namespace drydock::diagnosis
