#pragma once

#include <boost/container/static_vector.hpp>

namespace drydock::navigation {

/// A measured value minus the value that the filter expected, and the standard deviation that the
/// filter expects for this difference. Both have the unit of the value.
struct Innovation {
  double value = 0, sigma = 0;
  bool used = false;  ///< inside the gate

  double normalised_square() const { return value * value / (sigma * sigma); }
};

/// The innovations of one measurement, one row for each axis. The filter processes the rows one
/// after the other; each row is compared with the state after the rows before it. So for
/// independent axes the sum of the normalised squares is chi-square, with one degree of freedom for
/// each row.
using Innovations = boost::container::static_vector<Innovation, 3>;

}  // namespace drydock::navigation
