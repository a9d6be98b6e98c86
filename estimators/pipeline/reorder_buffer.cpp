#include "estimators/pipeline/reorder_buffer.hpp"

#include <algorithm>
#include <tuple>

namespace drydock::pipeline {

const measurement::Origin& origin_of(const Sample& sample) {
  return std::visit([](const auto& s) -> const measurement::Origin& { return s.origin; }, sample);
}

ReorderBuffer::ReorderBuffer(std::size_t capacity) : capacity_(capacity) {
  waiting_.reserve(capacity);
}

bool ReorderBuffer::after(const Waiting& a, const Waiting& b) {
  const auto key = [](const Waiting& w) {
    const measurement::Origin& from = origin_of(w.sample);
    return std::tuple{from.valid_at, w.sample.index(), from.device, w.arrival};
  };
  return key(a) > key(b);
}

void ReorderBuffer::push(const Sample& sample) {
  waiting_.push_back({sample, arrivals_++});
  std::push_heap(waiting_.begin(), waiting_.end(), after);
}

measurement::Stamp ReorderBuffer::oldest() const {
  return origin_of(waiting_.front().sample).valid_at;
}

Sample ReorderBuffer::pop() {
  std::pop_heap(waiting_.begin(), waiting_.end(), after);
  Sample sample = waiting_.back().sample;
  waiting_.pop_back();
  return sample;
}

}  // namespace drydock::pipeline
