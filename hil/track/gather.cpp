#include "hil/track/gather.hpp"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "hil/replay/replay_bench.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "hil/track/capture_rig.hpp"
#include "hil/track/gatherer.hpp"
#include "hil/track/played_capture.hpp"
#include "hil/track/setup.hpp"
#include "rig_config/load.hpp"

namespace drydock::track {
namespace {

rig_config::Rig rig_to_play(const replay::RecordedRig& recorded, const std::string& rig_file) {
  if (rig_file.empty()) return recorded.rig();
  auto rig = rig_config::load_rig(rig_file);
  if (!rig) throw std::runtime_error(rig_file + ": " + rig.error().front().what);
  return std::move(*rig);
}

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A recording with the rig that reads it.
struct Source {
  record::Recording recording;
  rig_config::Rig rig;
  std::map<std::string, measurement::Stamp> ends = {};  ///< of captures, by link
  bool of_arrival = true;  ///< its times are those at which its bytes came
};

Gathered gathered_from(Source& source, const record::Selection& part, host::Follower* also) {
  if (const auto wrong = record::misfit(part, source.recording); !wrong.empty())
    throw std::runtime_error(wrong);
  const auto& rig = source.rig;
  boost::asio::io_context io{1};
  replay::Pace pace(io, 0);
  replay::ReplayBench bench(source.recording, rig, part, {.ends = std::move(source.ends)});
  const auto inertial = part.from ? std::nullopt : inertial_of(rig);
  Gatherer gatherer(rig, inertial ? std::optional(inertial->imu) : std::nullopt);
  if (!source.of_arrival) gatherer.take_utc_of_receiver();
  bench.followers().add(gatherer);
  if (also != nullptr) bench.followers().add(*also);
  bench.play(pace, [](double) { return true; });
  Gathered gathered = gatherer.take();
  gathered.rig_text = text_of(rig.file);
  return gathered;
}

}  // namespace

Gathered gather_recording(const std::string& path, const record::Selection& part,
                          const std::string& rig_file, host::Follower* also) {
  auto recording = record::Recording::open(path);
  if (!recording) throw std::runtime_error(recording.error().line);
  const replay::RecordedRig recorded(*recording);
  auto rig = rig_to_play(recorded, rig_file);
  Source source{std::move(*recording), std::move(rig)};
  Gathered gathered = gathered_from(source, part, also);
  gathered.source = path;
  if (!recorded.trouble().empty()) gathered.notes.push_back(recorded.trouble());
  if (auto note = source.recording.clock_note(); !note.empty())
    gathered.notes.push_back(std::move(note));
  if (!source.recording.damage().empty())
    gathered.notes.push_back("the recording is damaged: " + source.recording.damage());
  return gathered;
}

Gathered gather_captures(const DiveSource& dive, host::Follower* also) {
  auto [read_by, made, shown] = dive_through_rig(dive);
  Source source{std::move(made.recording), std::move(read_by.rig), std::move(made.ends),
                made.of_arrival};
  Gathered gathered = gathered_from(source, dive.part, also);
  gathered.source = std::move(shown);
  std::ranges::move(read_by.notes, std::back_inserter(gathered.notes));
  std::ranges::move(made.notes, std::back_inserter(gathered.notes));
  return gathered;
}

Gathered gather_capture(const DiveSource& dive, host::Follower* also) {
  auto capture = one_capture(dive);
  auto made = rig_of_capture(capture.how, dive.rig, dive.part.only);
  made.rig.estimators.clear();  // the capture has one sensor: none of them can be fed
  const auto played = played_capture(made, dive.part);
  if (played.measurements.empty()) throw std::runtime_error(silence_of(capture, made, dive.part));
  Gatherer gatherer(made.rig, {});
  if (!played.times_of_capture) gatherer.take_utc_of_receiver();
  for (const auto& m : played.measurements) {
    gatherer.on_measurement(m);
    if (also != nullptr) also->on_measurement(m);
  }
  Gathered gathered = gatherer.take();
  gathered.source = std::move(capture.shown);
  if (!made.file.empty()) gathered.rig_text = made.text;
  std::ranges::move(capture.notes, std::back_inserter(gathered.notes));
  gathered.notes.insert(gathered.notes.end(), played.notes.begin(), played.notes.end());
  return gathered;
}

}  // namespace drydock::track
