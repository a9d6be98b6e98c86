#pragma once

#include <map>
#include <optional>

#include "hil/scorecard/run_record.hpp"

namespace drydock::scorecard {

/// The run without faults, and the numbers that it predicts for other runs. Noise, resolution and
/// motion move a number off the line between its neighbours. A number of another run may be off by
/// twice the largest such distance in the whole run.
class Reference {
 public:
  struct Expected {
    double value = 0, tolerance = 0;
  };

  explicit Reference(RunRecord run);

  const RunRecord& run() const { return run_; }

  /// The median time from one sample to the next.
  double period_s(std::size_t device, std::uint32_t series) const;

  /// Interpolated between the samples before and after that time. Empty if there is no sample
  /// within one and a half periods.
  std::optional<Expected> at(std::size_t device, std::uint32_t series, double valid_s) const;

  /// True if the number is within the tolerance. A number without a counterpart is not sound.
  bool sound(std::size_t device, std::uint32_t series, const Sample& sample) const;

 private:
  struct Scale {
    double tolerance = 0, period_s = 0;
  };
  static Scale scale_of(const Series& series);

  RunRecord run_;
  std::vector<std::map<std::uint32_t, Scale>> scales_;  ///< by device, then by series
};

/// b - a; for angles wrapped to +-pi.
double difference(const Series& series, double a, double b);

}  // namespace drydock::scorecard
