#pragma once

#include <cstdint>
#include <optional>

namespace drydock::navigation {

/// Squares of a filter's innovations over their own variances, of those that it took, one a row.
/// Their mean (NIS) is 1 for a filter that knows its errors, and needs no truth.
struct InnovationTally {
  double squares = 0;
  std::uint64_t count = 0;

  void add(double normalised_square) {
    squares += normalised_square;
    ++count;
  }
  std::optional<double> mean() const {
    return count > 0 ? std::optional{squares / static_cast<double>(count)} : std::nullopt;
  }
  friend InnovationTally operator+(const InnovationTally& a, const InnovationTally& b) {
    return {a.squares + b.squares, a.count + b.count};
  }
  /// Of what came after `earlier`.
  friend InnovationTally operator-(const InnovationTally& later, const InnovationTally& earlier) {
    return {later.squares - earlier.squares, later.count - earlier.count};
  }
};

}  // namespace drydock::navigation
