#include "hil/track/played_capture.hpp"

#include <fmt/format.h>

#include <optional>

#include "rig_config/file_trouble.hpp"

namespace drydock::track {

PlayedCapture played_capture(const CaptureRig& rig, const record::Selection& part) {
  PlayedCapture played;
  std::optional<measurement::Stamp> begin;
  const auto result = decode::play(rig.how, [&](const measurement::Measurement& m) {
    const auto at = measurement::origin_of(m).received_at;
    if (!begin) begin = at;
    if (part.holds(at, *begin)) played.measurements.push_back(m);
  });
  played.times_of_capture = result.clock.pace == shell::Pace::arrival;
  played.notes.push_back(result.clock.in_words());
  return played;
}

std::string silence_of(const OneCapture& capture, const CaptureRig& rig,
                       const record::Selection& part) {
  if (const auto trouble = rig_config::file_trouble(capture.how.capture); !trouble.empty())
    return capture.shown + ": " + trouble;
  if (part.from || part.to)
    return fmt::format("{}: no measurement between --from and --to", capture.shown);
  return fmt::format(
      "{}: the driver of {} made no measurement of it; `drydock info` tells what it holds, "
      "`drydock decode` what each message says",
      capture.shown, rig.how.protocol);
}

}  // namespace drydock::track
