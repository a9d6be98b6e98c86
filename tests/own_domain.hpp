#pragma once

#include <cstdint>

namespace drydock::test {

/// A DDS domain that no other test process of this machine holds, from 10 to 99: their ports are
/// below the ephemeral range. It is held until this process ends. Throws std::runtime_error.
std::uint32_t own_domain();

}  // namespace drydock::test
