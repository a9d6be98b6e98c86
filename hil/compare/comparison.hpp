#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "hil/compare/gaps.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::compare {

/// What one estimator made of the measurements.
struct Entry {
  std::string choice;  ///< as the person typed it
  summary::EstimatorSummary summary;
  std::uint64_t used = 0;  ///< measurements that it used
  double cpu_s = 0;        ///< processor time in it, all in all
  Gaps gaps;
  summary::AttitudeTrace attitude;
  summary::NavigationTrace navigation;  ///< errors; empty without a truth or without positions
  std::vector<frame::Position> places;  ///< of the map, thinned
  std::vector<std::string> notes;       ///< of its pipeline: refused, rejected, lost

  /// Processor time for each measurement that it used, microseconds. NaN: it used none.
  double cost_us() const;
};

/// Several estimators on the same measurements.
struct Comparison {
  std::string source;  ///< recording or rig file, as the person typed it
  double duration_s = 0;
  std::uint64_t measurements = 0;  ///< that each estimator got
  bool truth = false;              ///< errors are known
  std::vector<frame::Position> true_places;
  std::vector<Entry> entries;
  std::vector<std::string> notes;  ///< sentences for a person
};

std::string to_text(const Comparison& comparison);
std::string to_json(const Comparison& comparison);
/// One self-contained HTML page: the table, a map and the errors of all estimators over each other.
std::string to_html(const Comparison& comparison);

}  // namespace drydock::compare
