#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "tests/estimators/pipeline/support.hpp"

namespace {
// Of this whole test program; only the test below looks at it.
std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto to = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(to, (size + to - 1) / to * to)) return memory;
  throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace drydock::pipeline {
namespace {

struct LastEstimate final : EstimateListener {
  void on_attitude(const AttitudeEstimate& estimate) override { last = estimate; }
  AttitudeEstimate last;
};

TEST(Pipeline, AllocatesNothingPerSample) {
  for (const int window_ms : {0, 100}) {
    LastEstimate listener;
    auto pipeline = make_pipeline(test::moving(std::chrono::milliseconds{window_ms}), listener);
    const auto feed = [&](int from_ms, int to_ms) {
      for (int t = from_ms; t < to_ms; t += 10) {
        if (t % 500 == 0) pipeline->receive(test::water_speed(t - 100));
        pipeline->receive(test::imu(t));
        pipeline->advance(test::at_ms(t + 5));
      }
    };
    feed(0, 1000);
    const std::size_t before = allocations;
    feed(1000, 20000);
    EXPECT_EQ(allocations, before);
    EXPECT_GT(listener.last.valid_at, test::at_ms(19000));
  }
}

}  // namespace
}  // namespace drydock::pipeline
