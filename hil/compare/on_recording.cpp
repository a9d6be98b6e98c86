#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "estimators/host/diagnostician_beside.hpp"
#include "hil/compare/compare.hpp"
#include "hil/compare/contest.hpp"
#include "hil/compare/true_places.hpp"
#include "hil/replay/recorded_trajectory.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/rigs/other_rig.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "rig_config/load.hpp"

namespace drydock::compare {
namespace {

constexpr double usual_length_s = 3600;  ///< for the spacing of curves without a truth

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The devices alone: each contender has its estimator.
rig_config::Rig devices_of(rig_config::Rig rig) {
  rig.estimators.clear();
  rig.expects.clear();
  return rig;
}

replay::OtherRig rig_to_play(const replay::RecordedRig& recorded,
                             const record::Recording& recording, const std::string& file) {
  if (file.empty()) return {devices_of(recorded.rig()), {}};
  auto rig = rig_config::load_rig(file);
  if (!rig) throw std::invalid_argument(to_string(rig.error().front()));
  auto fitting = replay::fit(devices_of(*rig), recording, recorded.rig());
  if (fitting.rig.devices.size() != rig->devices.size())
    throw std::invalid_argument(fitting.notes.front() + "; take it out of the rig");
  return fitting;
}

/// Plays all of it to the contest. `findings` leave out devices that are not sound.
Comparison contended(replay::ReplayBench& bench, const rig_config::Rig& rig, Contest& contest,
                     bool findings) {
  const auto diagnostician = host::diagnostician_beside(rig, bench.devices(), bench.followers());
  if (findings) bench.followers().add(*diagnostician);
  bench.followers().add(contest);
  boost::asio::io_context io{1};
  replay::Pace pace(io, 0);
  bench.play(pace, [](double) { return true; });
  Comparison comparison;
  comparison.duration_s = measurement::seconds(bench.played());
  contest.write(comparison);
  return comparison;
}

}  // namespace

Comparison compare_on_recording(const CompareOptions& options) {
  auto recording = record::Recording::open(options.source.capture);
  if (!recording) throw std::runtime_error(recording.error().line);
  if (const auto wrong = record::misfit(options.part, *recording); !wrong.empty())
    throw std::invalid_argument(wrong);
  const replay::RecordedRig recorded(*recording);
  if (options.rig.empty() && !recorded.trouble().empty())
    throw std::runtime_error(recorded.trouble() + "; --rig names a rig file that is whole");
  const auto played = rig_to_play(recorded, *recording, options.rig);
  replay::ReplayBench bench(*recording, played.rig, options.part, {});
  const auto truth = replay::RecordedTrajectory::read(options.source.capture);
  const std::string file = options.rig.empty() ? recorded.rig().file : options.rig;
  Contest contest(text_of(file), file, options.estimators,
                  {truth.get(), bench.start(),
                   truth ? measurement::seconds(truth->end() - truth->start()) : usual_length_s});
  auto comparison = contended(bench, played.rig, contest, true);
  comparison.source = options.source.capture;
  comparison.truth = truth != nullptr;
  comparison.notes = played.notes;
  if (truth) comparison.true_places = true_places(*truth, truth->end());
  return comparison;
}

Comparison compare_through_rig(const CompareOptions& options) {
  auto dive = track::dive_through_rig(options);
  const auto rig = devices_of(std::move(dive.read_by.rig));
  if (const auto wrong = record::misfit(options.part, dive.made.recording); !wrong.empty())
    throw std::invalid_argument(wrong);
  std::vector<std::string> left_out;
  for (const auto& device : rig_config::load_rig(options.rig).value().devices)
    if (std::ranges::find(rig.devices, device.name, &rig_config::DeviceConfig::name) ==
        rig.devices.end())
      left_out.push_back(device.name);
  replay::ReplayBench bench(dive.made.recording, rig, options.part,
                            {.ends = std::move(dive.made.ends)});
  Contest contest(text_of(options.rig), options.rig, options.estimators,
                  {nullptr, bench.start(), usual_length_s}, left_out);
  auto comparison = contended(bench, rig, contest, rig.devices.size() > 1);
  comparison.source = dive.shown;
  comparison.notes = std::move(dive.read_by.notes);
  std::ranges::move(dive.made.notes, std::back_inserter(comparison.notes));
  return comparison;
}

}  // namespace drydock::compare
