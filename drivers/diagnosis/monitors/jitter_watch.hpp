#pragma once

#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Messages that are sent at the stated rate and held for random times on their way, from the start
/// on. Then one that is late makes the next interval shorter: neighbours have the correlation -1/2.
/// A sensor that pings unevenly has another mean, or intervals that know nothing of each other.
class JitterWatch {
 public:
  /// Of so long, and of so many intervals, the mean, the scatter and the correlation are taken.
  static constexpr std::chrono::seconds block{30};
  static constexpr int fewest = 60;

  /// `rate_hz`: as the rig states it; 0: nothing is told.
  explicit JitterWatch(double rate_hz = 0) : period_s_(rate_hz > 0 ? 1 / rate_hz : 0) {}

  void add(Stamp at);
  /// A message that this computer may have made late says nothing.
  void pass_over() { last_.reset(); }
  /// The next message has none before it.
  void interrupt();

  /// 1 sigma of the intervals, s. Empty: they scatter as those of a sound stream.
  std::optional<double> scatter_s() const { return scatter_s_; }
  double limit_s() const;
  Stamp since() const { return since_; }

 private:
  void close_block(Stamp at);
  std::optional<double> judge() const;

  double period_s_;
  std::optional<Stamp> begun_, last_;
  int count_ = 0;
  double before_s_ = 0;  ///< the interval before, less the period
  double sum_ = 0, squares_ = 0, products_ = 0;
  std::optional<double> scatter_s_;
  Stamp since_{};
};

}  // namespace drydock::diagnosis
