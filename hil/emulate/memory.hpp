#pragma once

#include <cstdint>
#include <vector>

namespace drydock::emulate {

/// What a device keeps without power, in a form of its own. Empty: it was never written.
struct Memory {
  std::vector<std::uint8_t> bytes;
};

}  // namespace drydock::emulate
