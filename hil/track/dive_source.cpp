#include "hil/track/dive_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "hil/replay/recording_file.hpp"
#include "hil/replay/replay_source.hpp"
#include "hil/replay/rigs/joined_capture.hpp"
#include "hil/replay/rigs/laid_capture.hpp"
#include "hil/track/capture_rig.hpp"

namespace drydock::track {
namespace {

std::vector<std::string> paths_of(const DiveSource& dive) {
  std::vector<std::string> paths;
  for (const auto& file : dive.captures) paths.push_back(file.path);
  if (paths.empty()) paths.push_back(dive.source.capture);
  return paths;
}

replay::RigCaptures captures_of(const DiveSource& dive) {
  if (dive.captures.empty()) return {{{dive.source.capture}}, dive.source};
  return {dive.captures, dive.source};
}

/// Which device reads which capture is the person's to say where it is not plain.
replay::OtherRig laid(const DiveSource& dive) {
  try {
    return replay::lay(replay::rig_in(dive.rig), captures_of(dive));
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

bool is_recording(const DiveSource& dive) {
  return dive.captures.empty() && replay::is_recording(dive.source.capture);
}

bool goes_through_rig(const DiveSource& dive) {
  if (dive.rig.empty()) return false;
  return !dive.captures.empty() || may_be_of_several(dive.source, dive.rig, dive.part.only);
}

DiveThroughRig dive_through_rig(const DiveSource& dive) {
  auto read_by = laid(dive);
  auto made = replay::record_capture(read_by.rig);
  return {std::move(read_by), std::move(made), fmt::format("{}", fmt::join(paths_of(dive), ", "))};
}

OneCapture one_capture(const DiveSource& dive) {
  const auto paths = paths_of(dive);
  OneCapture capture{dive.source, fmt::format("{}", fmt::join(paths, ", "))};
  if (dive.captures.empty()) return capture;
  auto joined = replay::join(paths, dive.source);
  capture.how.capture = joined.file->path();
  capture.how.format = joined.format;
  capture.notes = std::move(joined.notes);
  capture.file = std::move(joined.file);
  return capture;
}

}  // namespace drydock::track
