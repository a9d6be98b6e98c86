#pragma once

#include <cstdint>
#include <functional>

namespace drydock::bus::test {

/// Stamp of the one message among the garbage that is one.
inline constexpr std::int64_t good_sample_ns = 7'000'000'000;

/// Writes on `rt/gnss/satellites` what says to be a GnssSatellites and is any bytes: sequences
/// longer than the message, strings without an end. Then a good one, empty of satellites. `then` is
/// called while the writer still is there.
void write_garbage(std::uint32_t domain, const std::function<void()>& then);

}  // namespace drydock::bus::test
