#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/measurement/stamp.hpp"

namespace drydock::consistency {

/// Whether a latency explains the residuals of an alarm: a sensor that is late by tau differs by
/// y(t - tau) - y(t). While the quantity changes at a constant rate that is a constant, as with a
/// sensor that is off. When the manoeuvre is over, only the one that is off still differs.
class MaybeLate {
 public:
  static constexpr std::chrono::seconds longest{2};  ///< latency
  static constexpr int enough = 10;                  ///< residuals to tell the latency
  static constexpr int certain = 3;                  ///< residuals that no latency explains

  /// What the quantity is, all the time.
  void note(double quantity, measurement::Stamp at) {
    noted_[next_++ % noted_.size()] = {quantity, at};
    if (next_ == noted_.size()) next_ = 0;
  }
  /// An alarm begins to rise.
  void clear() { explained_ = squares_ = rates_ = 0, count_ = contradictions_ = 0; }
  /// `rate`: by how much dy/dt differs from that of the time before the alarm. `error`: of a
  /// residual, for other reasons.
  void take(double residual, double rate, double error) {
    squares_ += residual * residual;
    explained_ += residual * rate;
    rates_ += rate * rate;
    ++count_;
    contradictions_ += std::abs(residual) > change() + error ? 1 : 0;
  }

  bool is_contradicted() const { return contradictions_ >= certain; }
  /// The best tau is one that sensors have.
  bool is_possible() const {
    const double most_s = std::chrono::duration<double>(longest).count();
    return count_ >= enough && std::abs(explained_) < most_s * rates_;
  }
  /// Of the squares, by r = -tau dy/dt with the best tau.
  double left_over() const {
    return rates_ > 0 ? squares_ - explained_ * explained_ / rates_ : squares_;
  }

 private:
  struct Noted {
    double quantity = 0;
    measurement::Stamp at{};
  };
  /// The most by which the quantity differs from what it was within the longest latency.
  double change() const {
    const Noted& now = noted_[(next_ + noted_.size() - 1) % noted_.size()];
    double most = 0;
    for (const Noted& one : noted_)
      if (now.at - one.at <= longest) most = std::max(most, std::abs(now.quantity - one.quantity));
    return most;
  }

  std::array<Noted, 12> noted_{};
  std::size_t next_ = 0;
  double squares_ = 0, explained_ = 0, rates_ = 0;
  int count_ = 0, contradictions_ = 0;
};

}  // namespace drydock::consistency
