#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "tests/fuzz/fuzz_values.hpp"

namespace drydock::wire::fuzz {

/// Every 14 bytes are a frame: identifier (its top bit: 29 bits), length, flags, data. Feeds them
/// to a decoder. Every number in the messages must be finite, and the counters must agree.
template <class P>
void feed_frames(Bytes input) {
  constexpr std::size_t step = 14;
  typename P::Decoder decoder;
  std::uint64_t messages = 0;
  for (; input.size() >= step; input = input.subspan(step)) {
    CanFrame frame;
    std::memcpy(&frame.id, input.data(), sizeof(frame.id));
    frame.extended = frame.id >> 31 != 0;
    frame.id &= frame.extended ? 0x1FFFFFFFu : 0x7FFu;
    frame.size = input[4] % 9;
    frame.remote = (input[5] & 3) == 1;
    std::copy_n(input.data() + 6, 8, frame.data.begin());
    const auto message = decoder.receive(frame);
    if (!message) continue;
    ++messages;
    std::visit(
        [](const auto& m) {
          visit_fields(m, [](std::string_view, const auto& value) { require_finite(value); });
        },
        *message);
  }
  const StreamCounters& c = decoder.counters();
  if (c.frames != messages || c.bytes_good + c.bytes_skipped > c.bytes_in) std::abort();
}

}  // namespace drydock::wire::fuzz
