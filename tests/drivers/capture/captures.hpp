#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drivers/capture/frame_capture.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Reads captures to their end.
namespace drydock::capture::testing {

using wire::testing::Buffer;
using wire::testing::operator+;

/// A record that outlives its reader.
struct Seen {
  std::optional<std::chrono::nanoseconds> time;
  std::string interface;
  wire::CanFrame frame;
  friend bool operator==(const Seen&, const Seen&) = default;
};

struct Outcome {
  std::vector<Seen> records;
  std::string format;
  std::uint64_t units = 0, damaged = 0, bytes_skipped = 0;
  std::vector<std::uint64_t> where;
  bool unknown = false;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Feeds the capture in pieces of the given sizes. The last size is repeated.
inline Outcome read_capture(Bytes bytes, const std::vector<std::size_t>& pieces = {1u << 16},
                            const Format* format = nullptr) {
  FrameCapture capture(format);
  Outcome outcome;
  const auto drain = [&] {
    while (const auto record = capture.next()) {
      outcome.records.push_back({record->time, std::string(record->interface), record->frame});
    }
  };
  for (std::size_t i = 0; !bytes.empty(); ++i) {
    const auto size = std::min(pieces[std::min(i, pieces.size() - 1)], bytes.size());
    capture.feed(bytes.first(size));
    drain();
    bytes = bytes.subspan(size);
  }
  capture.finish();
  drain();
  const Tally& tally = capture.tally();
  EXPECT_EQ(tally.frames, outcome.records.size());
  if (capture.format() != nullptr) outcome.format = capture.format()->name;
  outcome.units = tally.units;
  outcome.damaged = tally.damaged;
  outcome.bytes_skipped = tally.bytes_skipped;
  outcome.where.assign(tally.where.begin(), tally.where.end());
  outcome.unknown = capture.unknown();
  return outcome;
}

inline Outcome read_capture(std::string_view text) {
  return read_capture(wire::testing::as_bytes(text));
}

/// The only record of a sound capture.
inline Seen only(const std::string& text) {
  const Outcome outcome = read_capture(text);
  EXPECT_EQ(outcome.records.size(), 1u) << text;
  EXPECT_EQ(outcome.damaged, 0u) << text;
  return outcome.records.empty() ? Seen{} : outcome.records.front();
}

inline std::vector<int> data_of(const Seen& seen) {
  return {seen.frame.data.begin(), seen.frame.data.begin() + seen.frame.size};
}

}  // namespace drydock::capture::testing
