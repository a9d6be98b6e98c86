#pragma once

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drydock::diagnosis {

/// Quantiles of numbers that come one by one. It keeps at most `Most` of them, spread over all that
/// came: when it is full, one of each two goes, and later one of each two, four ... is kept. Which
/// one is drawn, since numbers may alternate as they come. No allocation.
template <std::size_t Most>
class Spread {
 public:
  void add(double value) {
    const std::size_t place = count_++ % stride_;
    if (place == 0) chosen_ = drawn() % stride_;
    if (place != chosen_) return;
    if (kept_.size() == kept_.capacity()) thin();
    kept_.push_back(static_cast<float>(value));
  }

  std::size_t count() const { return count_; }
  std::span<const float> kept() const { return {kept_.data(), kept_.size()}; }

  /// The number that a share of all lies below. It reorders what is kept. 0 if there is none.
  double quantile(double share) {
    if (kept_.empty()) return 0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(kept_.size() - 1));
    std::nth_element(kept_.begin(), kept_.begin() + place, kept_.end());
    return static_cast<double>(kept_[static_cast<std::size_t>(place)]);
  }

 private:
  /// Marsaglia's xorshift: the same in each run.
  std::uint32_t drawn() {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    return random_ ^= random_ << 5;
  }
  void thin() {
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i + drawn() % 2];
    kept_.resize(kept_.size() / 2);
    stride_ *= 2;
  }

  boost::container::static_vector<float, Most> kept_;
  std::size_t count_ = 0, stride_ = 1, chosen_ = 0;
  std::uint32_t random_ = 2463534242;
};

}  // namespace drydock::diagnosis
