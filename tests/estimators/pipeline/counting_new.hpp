#pragma once

#include <cstddef>

namespace drydock::pipeline::test {

/// Calls of operator new so far, anywhere in this test program.
std::size_t allocations();

}  // namespace drydock::pipeline::test
