#pragma once

#include <array>
#include <boost/container/static_vector.hpp>

#include "estimators/roll/hypothesis.hpp"
#include "estimators/roll/satellite_slots.hpp"

namespace drydock::roll {

/// The filter of this project. It compares every satellite at every epoch with the pattern of the
/// antenna. The roll is unknown at first, so several hypotheses start at equal distances over the
/// turn. The signals weigh them: bad hypotheses are dropped, and hypotheses that meet become one.
/// Allocates nothing, throws nothing; inputs must be finite.
class AllSatellites {
 public:
  explicit AllSatellites(const AllSatellitesOptions& options);

  void predict(double rate_radps, double dt);  ///< does nothing before the first epoch
  void update(const Epoch& epoch);             ///< the first epoch starts the filter
  void restart();
  /// The signals contradict the roll: it is uncertain by the error that they tell, and the gyro's
  /// bias as much as at the start.
  void loosen();
  /// The gyro's bias may have changed by this sigma, rad/s.
  void loosen_bias(double sigma_radps);

  bool running() const { return !hypotheses_.empty(); }
  double roll() const;  ///< of the most likely hypothesis, (-pi, pi]
  /// Variance of roll(), rad2: the weighted variances of all hypotheses and their squared
  /// distances.
  double roll_variance() const;
  double bias() const { return best().state()(1); }  ///< of the gyro, rad/s
  double common_gain() const { return best().state()(2); }
  std::size_t hypotheses() const { return hypotheses_.size(); }
  std::uint64_t rejected() const { return rejected_; }  ///< signals outside the gate of the best

  /// What the signals say against the roll. Empty while several hypotheses are left.
  const RollWatch& watch() const { return watch_; }

  const Hypothesis& best() const { return hypotheses_.front(); }  ///< only when running()

 private:
  static constexpr std::size_t most_hypotheses = 24;

  void start();
  void weigh();

  AllSatellitesOptions options_;
  boost::container::static_vector<Hypothesis, most_hypotheses> hypotheses_;  ///< most likely first
  SatelliteSlots slots_;
  RollWatch watch_;
  double since_epoch_s_ = 0;
  std::uint64_t rejected_ = 0;
};

}  // namespace drydock::roll
