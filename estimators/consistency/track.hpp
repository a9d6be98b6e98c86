#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "estimators/consistency/freeze.hpp"

namespace drydock::consistency {

/// The last samples of one quantity of one device. It gives the value at a time between two of
/// them, so that sensors with different rates can be compared at one time.
template <int N, std::size_t Samples = 32>
class Track {
 public:
  using Value = Eigen::Matrix<double, N, 1>;

  /// `longest_gap`: values between samples that lie farther apart are not given.
  explicit Track(std::chrono::nanoseconds longest_gap) : longest_gap_(longest_gap) {}

  /// A value that is no number is not taken. A time that does not advance is not taken; if it goes
  /// back by more than the longest gap, the device's clock was set and the track begins anew.
  void push(Stamp at, const Value& value) {
    if (!value.allFinite()) return;
    if (count_ > 0 && at <= last().at) {
      if (last().at - at <= longest_gap_) return;
      count_ = 0;
    }
    freeze_.see(at, count_ > 0 ? (value - newest_).cwiseAbs().sum() : 1);
    newest_ = value;
    if (count_ > 0 && at - last().at < shortest_gap) return;
    ring_[++count_ % Samples] = {at, value};
  }

  struct Reading {
    Value value;
    std::uint64_t serial;  ///< it changes when a new sample was needed
  };

  /// Linear between the samples before and after. Empty: there are none, or too far apart.
  std::optional<Reading> at(Stamp time) const {
    const std::uint64_t oldest = count_ > Samples ? count_ - Samples + 1 : 1;
    for (std::uint64_t k = count_; k > oldest; --k) {
      const Sample& before = ring_[(k - 1) % Samples];
      if (before.at > time) continue;
      const Sample& after = ring_[k % Samples];
      if (after.at < time || after.at - before.at > longest_gap_) return {};
      const double part =
          measurement::seconds(time - before.at) / measurement::seconds(after.at - before.at);
      return Reading{before.value + part * (after.value - before.value), k};
    }
    return {};
  }

  const Freeze& freeze() const { return freeze_; }

 private:
  struct Sample {
    Stamp at{};
    Value value = Value::Zero();
  };
  /// Samples of a fast device that lie closer are not kept, so that the ring reaches back far
  /// enough.
  static constexpr std::chrono::milliseconds shortest_gap{N == 8 ? 0 : 60};
  const Sample& last() const { return ring_[count_ % Samples]; }

  std::chrono::nanoseconds longest_gap_;
  std::array<Sample, Samples> ring_{};
  std::uint64_t count_ = 0;
  Value newest_ = Value::Zero();
  Freeze freeze_;
};

}  // namespace drydock::consistency
