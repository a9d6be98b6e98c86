#include "hil/replay/summarize.hpp"

#include <boost/asio/io_context.hpp>
#include <optional>
#include <stdexcept>

#include "drivers/host/finding_log.hpp"
#include "estimators/host/diagnostician_beside.hpp"
#include "estimators/host/sound_devices.hpp"
#include "hil/replay/recording_progress.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/replay_summary.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "hil/summary/findings.hpp"

namespace drydock::replay {

summary::Summary summarize(const std::string& path) {
  auto recording = record::Recording::open(path);
  if (!recording) throw std::runtime_error(recording.error().line);
  const RecordedRig recorded(*recording);
  const auto& rig = recorded.rig();
  const record::Selection whole;
  std::optional<ReplaySummary> told;
  ReplayBench bench(*recording, rig, whole, {.at_end = [&] { told->note_end(); }});
  auto& followers = bench.followers();
  const auto diagnostician = host::diagnostician_beside(rig, bench.devices(), followers);
  host::SoundDevices sound_devices(rig, bench.pipeline());
  host::FindingLog findings;
  followers.add(*diagnostician);
  followers.add(sound_devices);
  followers.add(findings);
  told.emplace(rig, bench, path, RecordedTrajectory::read(path));
  boost::asio::io_context io{1};
  Pace pace(io, 0);
  RecordingProgress progress("diff", stderr);
  bench.play(pace, std::ref(progress));
  auto made = told->made();
  made.findings = summary::accounts_of(findings, rig, bench.start());
  return made;
}

}  // namespace drydock::replay
