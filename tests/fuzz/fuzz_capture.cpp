#include <cstdlib>
#include <vector>

#include "drivers/capture/frame_capture.hpp"

using namespace drydock;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

struct Outcome {
  std::vector<wire::CanFrame> frames;
  std::uint64_t units = 0, damaged = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome read(wire::Bytes bytes, std::size_t piece) {
  capture::FrameCapture capture;
  Outcome outcome;
  const auto drain = [&] {
    while (const auto record = capture.next()) outcome.frames.push_back(record->frame);
  };
  while (!bytes.empty()) {
    const wire::Bytes part = bytes.first(std::min(piece, bytes.size()));
    capture.feed(part);
    drain();
    bytes = bytes.subspan(part.size());
  }
  capture.finish();
  drain();
  require(capture.tally().frames == outcome.frames.size());
  outcome.units = capture.tally().units;
  outcome.damaged = capture.tally().damaged;
  return outcome;
}

}  // namespace

/// A capture of any recognised format gives only valid frames. It gives the same frames as a whole
/// and in pieces. The last byte is the length of the pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const wire::Bytes bytes{data, size};
  if (bytes.empty()) return 0;
  const Outcome whole = read(bytes, bytes.size());
  for (const wire::CanFrame& frame : whole.frames) {
    require(frame.id <= (frame.extended || frame.error ? 0x1FFFFFFFu : 0x7FFu));
    require(frame.size <= (frame.fd ? 64 : 8));
  }
  require(read(bytes, std::size_t{1} + bytes.back()) == whole);
  return 0;
}
