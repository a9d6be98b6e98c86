#pragma once

#include <array>
#include <boost/container/static_vector.hpp>

#include "estimators/roll/hypothesis.hpp"
#include "estimators/roll/satellite_slots.hpp"

namespace drydock::roll {

/// Ours: every satellite at every epoch against the antenna's pattern. Nothing is known of the roll
/// at first, so several filters start around the turn; the signals weigh them, those that explain
/// them badly are dropped, and those that meet become one. Allocates nothing, throws nothing;
/// inputs must be finite.
class AllSatellites {
 public:
  explicit AllSatellites(const AllSatellitesOptions& options);

  void predict(double rate_radps, double dt);  ///< nothing before the first epoch
  void update(const Epoch& epoch);             ///< the first one starts it
  void restart() { hypotheses_.clear(); }

  bool running() const { return !hypotheses_.empty(); }
  double roll() const;  ///< of the likeliest hypothesis, (-pi, pi]
  /// Of that roll, rad2: the hypothesis's own, and how far the others are from it, by their weight.
  double roll_variance() const;
  double bias() const { return best().state()(1); }  ///< of the gyro, rad/s
  double common_gain() const { return best().state()(2); }
  std::size_t hypotheses() const { return hypotheses_.size(); }
  std::uint64_t rejected() const { return rejected_; }  ///< signals outside the best one's gate

  const Hypothesis& best() const { return hypotheses_.front(); }  ///< only when running()

 private:
  static constexpr std::size_t most_hypotheses = 24;

  void start();
  void weigh();

  AllSatellitesOptions options_;
  boost::container::static_vector<Hypothesis, most_hypotheses> hypotheses_;  ///< likeliest first
  SatelliteSlots slots_;
  std::uint64_t rejected_ = 0;
};

}  // namespace drydock::roll
