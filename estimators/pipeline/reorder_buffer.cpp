#include "estimators/pipeline/reorder_buffer.hpp"

#include <algorithm>
#include <tuple>

namespace drydock::pipeline {

const measurement::Origin& origin_of(const Sample& sample) {
  return std::visit([](const auto& s) -> const measurement::Origin& { return s.origin; }, sample);
}

ReorderBuffer::ReorderBuffer(std::size_t capacity) : capacity_(capacity) {
  waiting_.reserve(capacity);
  samples_.reserve(capacity);
  free_.reserve(capacity);
}

bool ReorderBuffer::after(const Waiting& a, const Waiting& b) {
  const auto key = [](const Waiting& w) {
    return std::tuple{w.valid_at, w.kind, w.device, w.arrival};
  };
  return key(a) > key(b);
}

void ReorderBuffer::push(const Sample& sample) {
  const measurement::Origin& from = origin_of(sample);
  waiting_.push_back({from.valid_at, sample.index(), from.device, arrivals_++, put(sample)});
  std::push_heap(waiting_.begin(), waiting_.end(), after);
}

std::size_t ReorderBuffer::put(const Sample& sample) {
  if (free_.empty()) {
    samples_.push_back(sample);
    return samples_.size() - 1;
  }
  const std::size_t place = free_.back();
  free_.pop_back();
  samples_[place] = sample;
  return place;
}

measurement::Stamp ReorderBuffer::oldest() const { return waiting_.front().valid_at; }

Sample ReorderBuffer::pop() {
  std::pop_heap(waiting_.begin(), waiting_.end(), after);
  const std::size_t place = waiting_.back().place;
  waiting_.pop_back();
  free_.push_back(place);
  return samples_[place];
}

}  // namespace drydock::pipeline
