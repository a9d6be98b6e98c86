#include "hil/replay/capture_report.hpp"

#include <chrono>

#include "hil/summary/scribe.hpp"

namespace drydock::replay {

namespace {

using measurement::Measurement;
using measurement::Stamp;

rig_config::Rig rig_of(const device::HealthAccount& account, measurement::Kind kind) {
  rig_config::Rig rig;
  rig.name = account.name;
  auto& device = rig.devices.emplace_back();
  device.name = account.name;
  device.kind = kind;
  device.protocol = account.protocol;
  device.link = account.link;
  return rig;
}

}  // namespace

summary::Summary summary_of_capture(decode::ReplayOptions capture) {
  const auto begun = std::chrono::steady_clock::now();
  capture.speed = "max";
  std::vector<Measurement> all;
  const auto played = decode::play(capture, [&](const Measurement& m) { all.push_back(m); });
  const auto rig = rig_of(played.account, played.kind);
  const Stamp start = played.clock.first;
  const Stamp end = all.empty() ? start : origin_of(all.back()).received_at;

  summary::Summary summary;
  summary.rig = capture.capture;
  summary.mode = "replay of a capture";
  summary.duration_s = measurement::seconds(end - start);
  summary.notes = {played.clock.in_words(),
                   "no faults were looked for in it: drydock diagnose does that"};
  summary.devices = {played.account};
  summary::Scribe scribe(rig, nullptr, start, summary.duration_s);
  for (const auto& m : all) scribe.on_measurement(m);
  scribe.write(summary);
  summary.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return summary;
}

}  // namespace drydock::replay
