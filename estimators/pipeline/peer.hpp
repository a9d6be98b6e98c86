#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "estimators/pipeline/estimate.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "estimators/pipeline/reorder_buffer.hpp"

namespace drydock::pipeline {

/// What an estimator outside this program gave. Values that it does not give are NaN.
using OutsideEstimate = std::variant<AttitudeEstimate, NavigationEstimate>;

Stamp valid_at(const OutsideEstimate& estimate);

/// How the talk with an estimator outside went. Everything but the first three is a fault of it.
struct PeerAccount {
  bool in_steps = true;              ///< false: it publishes when it likes and is sent nothing
  std::uint64_t steps = 0;           ///< sent to it
  std::uint64_t answers = 0;         ///< one for each step, or what it published
  double mean_s = 0, longest_s = 0;  ///< from a step to its answer; of a topic: from valid_at to
                                     ///< when it was sent
  std::uint64_t late = 0;            ///< answers after the time that the rig allows
  std::uint64_t twice = 0;           ///< to a step that had its answer
  std::uint64_t malformed = 0;       ///< lines or values that are not of the protocol
  std::uint64_t not_finite = 0;      ///< NaN or infinite
  std::uint64_t out_of_time = 0;     ///< estimates of the future, or older than the one before
  std::string failure;               ///< why there are no more answers, with its time; empty: none

  std::uint64_t faults() const {
    return late + twice + malformed + not_finite + out_of_time + (failure.empty() ? 0 : 1);
  }
};

/// The measurements of one step, in the order of the pipeline. No older ones come later, except
/// those that the pipeline calls late.
struct Step {
  std::uint64_t number = 0;  ///< from 1
  Stamp now{};               ///< its end: all of the measurements are older
  std::span<const Sample> samples;
};

/// The other end of an estimator outside this program. It never throws.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Hands over a step. Appends the estimates that have come by then to `into`.
  virtual void exchange(const Step& step, std::vector<OutsideEstimate>& into) = 0;
  /// Appends what came since, without a step.
  virtual void poll(std::vector<OutsideEstimate>& into) = 0;
  /// Appends what is still to come at the end of a run.
  virtual void finish(std::vector<OutsideEstimate>& into) = 0;
  /// An estimate was refused because of its time.
  virtual void refuse(const OutsideEstimate& estimate, Stamp now) = 0;
  virtual const PeerAccount& account() const = 0;
};

}  // namespace drydock::pipeline
