#pragma once

#include <cstddef>

namespace drydock::device::test {

/// Counts the program's calls of operator new since its construction.
class AllocationCount {
 public:
  AllocationCount();
  std::size_t so_far() const;

 private:
  std::size_t before_;
};

}  // namespace drydock::device::test
