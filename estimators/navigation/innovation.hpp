#pragma once

#include <boost/container/static_vector.hpp>

namespace drydock::navigation {

/// A measured value less the one that the filter expected, and the standard deviation that the
/// filter gives this difference, both in the value's unit.
struct Innovation {
  double value = 0, sigma = 0;
  bool used = false;  ///< inside the gate

  double normalised_square() const { return value * value / (sigma * sigma); }
};

/// Of one measurement, a row an axis. Rows are taken one after the other, each against what the
/// rows before have left: of independent axes all squares together are chi-square with as many
/// degrees of freedom as there are rows.
using Innovations = boost::container::static_vector<Innovation, 3>;

}  // namespace drydock::navigation
