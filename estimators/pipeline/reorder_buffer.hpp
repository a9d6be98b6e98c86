#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "drivers/measurement/measurement.hpp"

namespace drydock::pipeline {

/// The kinds of measurement that at least one estimator uses.
using Sample =
    std::variant<measurement::ImuSample, measurement::WaterSpeed, measurement::GnssFix,
                 measurement::GnssSatellites, measurement::DepthSample, measurement::BottomVelocity,
                 measurement::ActuatorState, measurement::AttitudeSample>;

const measurement::Origin& origin_of(const Sample& sample);

/// Fixed-capacity priority queue by valid_at. Equal stamps are ordered by the kind as in `Sample`
/// (IMU samples first), then by device index, then by arrival. So the order of arrival matters only
/// if one device gives two samples of the same instant.
class ReorderBuffer {
 public:
  explicit ReorderBuffer(std::size_t capacity);

  bool empty() const { return waiting_.empty(); }
  bool full() const { return waiting_.size() == capacity_; }
  std::size_t size() const { return waiting_.size(); }

  /// Must not be full.
  void push(const Sample& sample);

  /// valid_at of the oldest. Must not be empty.
  measurement::Stamp oldest() const;

  /// Removes the oldest and returns it. Must not be empty.
  Sample pop();

 private:
  struct Waiting {
    measurement::Stamp valid_at;
    std::size_t kind = 0;  ///< index of Sample
    std::uint16_t device = 0;
    std::uint64_t arrival = 0;
    std::size_t place = 0;  ///< in samples_
  };
  static bool after(const Waiting& a, const Waiting& b);
  std::size_t put(const Sample& sample);

  std::size_t capacity_;
  std::vector<Waiting> waiting_;   ///< a heap; memory is reserved once, also for the next two
  std::vector<Sample> samples_;    ///< the heap moves only indices, because a sample is large
  std::vector<std::size_t> free_;  ///< places in samples_
  std::uint64_t arrivals_ = 0;
};

}  // namespace drydock::pipeline
