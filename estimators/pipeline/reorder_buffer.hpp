#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "drivers/measurement/measurement.hpp"

namespace drydock::pipeline {

/// The kinds of measurement that some estimator takes.
using Sample = std::variant<measurement::ImuSample, measurement::WaterSpeed>;

const measurement::Origin& origin_of(const Sample& sample);

/// Fixed-capacity priority queue by valid_at. Of equal stamps IMU samples come before speeds, then
/// the lower device index, then the first to arrive: the order of arrival plays no part unless one
/// device gives two samples of the same instant.
class ReorderBuffer {
 public:
  explicit ReorderBuffer(std::size_t capacity);

  bool empty() const { return waiting_.empty(); }
  bool full() const { return waiting_.size() == capacity_; }
  std::size_t size() const { return waiting_.size(); }

  /// Must not be full.
  void push(const Sample& sample);

  /// valid_at of the oldest; must not be empty.
  measurement::Stamp oldest() const;

  /// Takes the oldest out; must not be empty.
  Sample pop();

 private:
  struct Waiting {
    Sample sample;
    std::uint64_t arrival = 0;
  };
  static bool after(const Waiting& a, const Waiting& b);

  std::size_t capacity_;
  std::vector<Waiting> waiting_;  ///< a heap, reserved once
  std::uint64_t arrivals_ = 0;
};

}  // namespace drydock::pipeline
