#pragma once

#include <cstdlib>
#include <memory>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "tests/fuzz/fuzz_values.hpp"

namespace drydock::wire::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Feeds the input in pieces (its first byte is their length) and decodes the frames. Every number
/// in the messages must be finite.
template <class P>
void feed(Bytes input) {
  if (input.empty()) return;
  const std::size_t piece = std::size_t{1} + input[0];
  const auto framer = std::make_unique<Framer<P::max_frame>>();
  for (Bytes rest = input.subspan(1); !rest.empty();) {
    const Bytes part = rest.first(std::min(piece, rest.size()));
    framer->feed(part, P::scan, [](Bytes frame, std::size_t after) {
      require(frame.size() <= P::max_frame && after <= P::max_frame + 256);
      const auto message = P::decode(frame);
      if (!message) return;
      std::visit(
          [](const auto& m) {
            visit_fields(m, [](std::string_view, const auto& value) { require_finite(value); });
          },
          *message);
    });
    rest = rest.subspan(part.size());
  }
  const StreamCounters& c = framer->counters();
  require(c.bytes_in == input.size() - 1);
  require(c.bytes_in == c.bytes_good + c.bytes_skipped + framer->held());
  P::decode(input);
}

}  // namespace drydock::wire::fuzz
