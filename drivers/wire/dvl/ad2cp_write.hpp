#pragma once

#include <chrono>
#include <cstdint>
#include <span>

namespace drydock::wire::ad2cp {

/// Year since 1900, month from 0, day, hour, minute, second, u16 of 100 us.
void write_clock(std::chrono::microseconds clock, std::span<std::uint8_t> to);

}  // namespace drydock::wire::ad2cp
