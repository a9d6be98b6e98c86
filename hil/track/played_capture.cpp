#include "hil/track/played_capture.hpp"

#include <optional>

namespace drydock::track {

PlayedCapture played_capture(const CaptureRig& rig, const record::Selection& part) {
  PlayedCapture played;
  std::optional<measurement::Stamp> begin;
  const auto result = decode::play(rig.how, [&](const measurement::Measurement& m) {
    const auto at = measurement::origin_of(m).received_at;
    if (!begin) begin = at;
    if (part.holds(at, *begin)) played.measurements.push_back(m);
  });
  played.notes.push_back(result.clock.in_words());
  return played;
}

}  // namespace drydock::track
