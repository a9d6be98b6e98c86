#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/recordings/record/player.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "hil/bench/run.hpp"
#include "hil/characterize/report/characterize.hpp"
#include "hil/check/check_rig.hpp"
#include "hil/sensor/mounting.hpp"
#include "rig_config/load.hpp"

namespace drydock::characterize {
namespace {

using characterize::Samples;
using characterize::Subject;

Subject subject_of(const rig_config::DeviceConfig& config) {
  const auto mounting = sensor::mounting_of(config);
  return {config.name, config.kind, config.rate_hz, mounting.sensor_to_body, mounting.lever_arm_m};
}

/// True if the other end of the link can run in virtual time.
bool virtual_time(const rig_config::DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri && (uri->emulated() || uri->recorded());
}

/// Throws std::invalid_argument with the lines of `drydock check`.
rig_config::Rig sound_rig(const std::string& path) {
  auto rig = check::load_sound_rig(path);
  if (rig) return std::move(*rig);
  std::string lines;
  for (const auto& problem : rig.error()) lines += (lines.empty() ? "" : "\n") + to_string(problem);
  throw std::invalid_argument(lines);
}

/// Adds the measurements of a run to those of their devices.
class Gatherer final : public bench::Follower {
 public:
  explicit Gatherer(Gathered& to) : to_(to) {}
  void on_measurement(const measurement::Measurement& m) override {
    to_.devices.at(measurement::origin_of(m).device).add(m);
  }

 private:
  Gathered& to_;
};

Gathered gather_rig(const CharacterizeOptions& options) {
  auto rig = sound_rig(options.source);
  rig.estimators.clear();
  rig.expects.clear();
  Gathered gathered;
  for (const auto& config : rig.devices) {
    gathered.devices.emplace_back(subject_of(config));
    gathered.named.emplace_back(
        characterize::NamedGrade{config.name + " in the rig file", config.emulate});
  }
  constexpr double default_lockstep_s = 3600, default_real_time_s = 60;
  bench::RunOptions run;
  run.lockstep = std::ranges::all_of(rig.devices, virtual_time);
  run.duration_s =
      options.duration_s.value_or(run.lockstep ? default_lockstep_s : default_real_time_s);
  Gatherer gatherer(gathered);
  run.followers = {&gatherer};
  const summary::Summary summary =
      run.lockstep ? bench::run_lockstep(rig, run) : bench::run_real_time(rig, run);
  gathered.notes.push_back(fmt::format("rig {}: {:.6g} s in {}", rig.name, summary.duration_s,
                                       run.lockstep ? "virtual time" : "real time"));
  return gathered;
}

const rig_config::DeviceConfig* device_of(const rig_config::Rig& rig, const std::string& name) {
  const auto found = std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
  return found == rig.devices.end() ? nullptr : &*found;
}

Gathered gather_recording(const CharacterizeOptions& options) {
  auto recording = record::Recording::open(options.source).value();
  const auto rig = record::rig_of(recording);
  bus::CdrMeasurements decoder;
  Gathered gathered;
  struct Channel {
    std::size_t device = 0;
    bus::Kind kind = bus::Kind::imu;
  };
  std::map<const mcap::Channel*, std::optional<Channel>> channels;
  std::uint64_t unreadable = 0;
  while (const auto event = recording.next()) {
    const auto* understood = std::get_if<record::Understood>(&*event);
    if (understood == nullptr) continue;
    auto [known, is_new] = channels.try_emplace(understood->channel);
    if (is_new) {
      if (const auto topic =
              bus::measurement_topic(understood->channel->topic, understood->schema->name)) {
        known->second = Channel{gathered.devices.size(), topic->kind};
        const auto* config = rig ? device_of(*rig, topic->device) : nullptr;
        gathered.devices.emplace_back(config != nullptr ? subject_of(*config)
                                                        : Subject{topic->device, topic->kind});
      }
    }
    if (!known->second) continue;
    const auto [device, kind] = *known->second;
    if (const auto m = decoder.read(kind, understood->cdr, understood->at)) {
      gathered.devices[device].add(*m);
    } else {
      ++unreadable;
    }
  }
  if (!rig)
    gathered.notes.emplace_back(
        "axes are the body's, lever arms are not known: no rig is attached");
  if (unreadable > 0)
    gathered.notes.push_back(fmt::format("{} messages are no measurements", unreadable));
  if (auto note = recording.clock_note(); !note.empty()) gathered.notes.push_back(std::move(note));
  if (!recording.damage().empty()) gathered.notes.push_back(recording.damage());
  return gathered;
}

Subject::Times times_of(shell::Pace pace) {
  switch (pace) {
    case shell::Pace::arrival: return Subject::Times::of_arrival;
    case shell::Pace::device: return Subject::Times::of_device;
    case shell::Pace::line: break;
  }
  return Subject::Times::none;
}

Gathered gather_capture(const CharacterizeOptions& options) {
  if (options.capture.protocol.empty())
    throw std::invalid_argument(
        options.source +
        ": a capture needs --protocol; a recording ends in .mcap, a rig file in .toml");
  decode::ReplayOptions replay = options.capture;
  replay.capture = options.source;
  Gathered gathered;
  Samples samples{Subject{}};
  const auto played =
      decode::play(replay, [&samples](const measurement::Measurement& m) { samples.add(m); });
  samples.subject.kind = played.kind;
  samples.subject.name = to_string(played.kind);
  samples.subject.times = times_of(played.clock.pace);
  gathered.notes.push_back(played.clock.in_words());
  gathered.devices.push_back(std::move(samples));
  return gathered;
}

}  // namespace

Gathered gather(const CharacterizeOptions& options) {
  Gathered gathered = options.source.ends_with(".toml")   ? gather_rig(options)
                      : options.source.ends_with(".mcap") ? gather_recording(options)
                                                          : gather_capture(options);
  gathered.named.resize(gathered.devices.size());
  return gathered;
}

}  // namespace drydock::characterize
