#pragma once

#include <cstddef>

namespace drydock::pipeline::test {

/// Number of calls of operator new so far in this test program.
std::size_t allocations();

}  // namespace drydock::pipeline::test
