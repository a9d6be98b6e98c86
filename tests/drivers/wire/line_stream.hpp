#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::test {

/// The frames of a stream as text, and the counters at the end.
struct CutStream {
  std::vector<std::string> frames;
  StreamCounters counters;
  std::size_t held = 0;
  bool operator==(const CutStream&) const = default;
};

template <class P>
CutStream cut_stream(const std::vector<std::string>& pieces) {
  Framer<P::max_frame> framer;
  CutStream cut;
  for (const std::string& piece : pieces) {
    framer.feed(as_bytes(piece), P::scan, [&](Bytes frame, std::size_t) {
      cut.frames.emplace_back(frame.begin(), frame.end());
    });
  }
  cut.counters = framer.counters();
  cut.held = framer.held();
  return cut;
}

inline std::vector<std::string> split_at_random(const std::string& text) {
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < text.size();) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 40);
    pieces.push_back(text.substr(at, size));
    at += size;
  }
  return pieces;
}

}  // namespace drydock::wire::test
