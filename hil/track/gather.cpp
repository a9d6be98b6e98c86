#include "hil/track/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "hil/replay/recorded_rig.hpp"
#include "hil/replay/replay_bench.hpp"
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

}  // namespace

Gathered gather_recording(const std::string& path, const record::Selection& part,
                          const std::string& rig_file, host::Follower* also) {
  auto recording = record::Recording::open(path);
  if (!recording) throw std::runtime_error(recording.error().line);
  if (const auto wrong = record::misfit(part, *recording); !wrong.empty())
    throw std::runtime_error(wrong);
  const replay::RecordedRig recorded(*recording);
  const auto rig = rig_to_play(recorded, rig_file);
  boost::asio::io_context io{1};
  replay::Pace pace(io, 0);
  replay::ReplayBench bench(*recording, rig, part, {});
  const auto inertial = part.from ? std::nullopt : inertial_of(rig);
  Gatherer gatherer(rig, inertial ? std::optional(inertial->imu) : std::nullopt);
  bench.followers().add(gatherer);
  if (also != nullptr) bench.followers().add(*also);
  bench.play(pace, [](double) { return true; });
  Gathered gathered = gatherer.take();
  gathered.source = path;
  gathered.rig_text = text_of(rig.file);
  if (!recorded.trouble().empty()) gathered.notes.push_back(recorded.trouble());
  if (auto note = recording->clock_note(); !note.empty()) gathered.notes.push_back(std::move(note));
  if (!recording->damage().empty())
    gathered.notes.push_back("the recording is damaged: " + recording->damage());
  return gathered;
}

Gathered gather_capture(const decode::ReplayOptions& capture, const record::Selection& part,
                        const std::string& rig_file, host::Follower* also) {
  auto made = rig_of_capture(capture, rig_file, part.only);
  made.rig.estimators.clear();  // the capture has one sensor: none of them can be fed
  const auto played = played_capture(made, part);
  if (played.measurements.empty()) throw std::runtime_error(silence_of(capture, made, part));
  Gatherer gatherer(made.rig, {});
  if (!played.times_of_capture) gatherer.take_utc_of_receiver();
  for (const auto& m : played.measurements) {
    gatherer.on_measurement(m);
    if (also != nullptr) also->on_measurement(m);
  }
  Gathered gathered = gatherer.take();
  gathered.source = capture.capture;
  if (!made.file.empty()) gathered.rig_text = made.text;
  gathered.notes.insert(gathered.notes.end(), played.notes.begin(), played.notes.end());
  return gathered;
}

}  // namespace drydock::track
