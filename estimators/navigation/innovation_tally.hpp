#pragma once

#include <cstdint>
#include <optional>

namespace drydock::navigation {

/// Sum of the normalised squares of the innovations that a filter used, one for each row. Their
/// mean (NIS) is 1 for a consistent filter. It needs no truth.
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
  /// The tally of the innovations after `earlier`.
  friend InnovationTally operator-(const InnovationTally& later, const InnovationTally& earlier) {
    return {later.squares - earlier.squares, later.count - earlier.count};
  }
};

}  // namespace drydock::navigation
