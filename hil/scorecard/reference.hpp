#pragma once

#include <map>
#include <optional>

#include "hil/scorecard/run_record.hpp"

namespace drydock::scorecard {

/// The run without faults, and what it leads one to expect of the others. Noise, resolution and
/// motion put a number off the line between its neighbours: twice the most of a whole run is
/// allowed to a number of another run.
class Reference {
 public:
  struct Expected {
    double value = 0, tolerance = 0;
  };

  explicit Reference(RunRecord run);

  const RunRecord& run() const { return run_; }

  /// The usual time from one sample to the next.
  double period_s(std::size_t device, std::uint32_t series) const;

  /// Between the samples beside that time; empty where there are none within a period and a half.
  std::optional<Expected> at(std::size_t device, std::uint32_t series, double valid_s) const;

  /// Whether the number is as expected. One without a counterpart is not.
  bool sound(std::size_t device, std::uint32_t series, const Sample& sample) const;

 private:
  struct Scale {
    double tolerance = 0, period_s = 0;
  };
  static Scale scale_of(const Series& series);

  RunRecord run_;
  std::vector<std::map<std::uint32_t, Scale>> scales_;  ///< by device
};

/// b - a; of angles the short way round.
double difference(const Series& series, double a, double b);

}  // namespace drydock::scorecard
