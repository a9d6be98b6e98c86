#include "tests/drivers/device/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::size_t> allocations{0};
}

// Replaces the allocation functions of the whole test program. It is a separate file: otherwise the
// compiler could see malloc through new and would warn about the pair.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size ? size : 1);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace drydock::device::test {

AllocationCount::AllocationCount() : before_(allocations) {}
std::size_t AllocationCount::so_far() const { return allocations - before_; }

}  // namespace drydock::device::test
