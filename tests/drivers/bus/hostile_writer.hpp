#pragma once

#include <cstdint>
#include <functional>

namespace drydock::bus::test {

/// Stamp of the only valid message among the garbage.
inline constexpr std::int64_t good_sample_ns = 7'000'000'000;

/// Writes garbage on `rt/gnss/satellites` that claims to be a GnssSatellites: sequences longer than
/// the message, strings without an end. Then it writes a valid message without satellites. It calls
/// `then` while the writer still exists.
void write_garbage(std::uint32_t domain, const std::function<void()>& then);

}  // namespace drydock::bus::test
