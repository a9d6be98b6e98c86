#include "hil/bench/lockstep_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/host/rig_bus.hpp"
#include "drivers/shell/recorded_bus.hpp"
#include "drivers/shell/recorded_line.hpp"
#include "drivers/shell/recorded_starts.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "rig_config/steering.hpp"

namespace drydock::bench {
namespace {

using measurement::Stamp;

constexpr unsigned default_bit_rate = 250'000;

/// Another program has a clock of its own.
const rig_config::Rig& not_steered_by_a_program(const rig_config::Rig& rig) {
  if (rig.mission.steering && !rig_config::steered_over_wires(rig.mission))
    throw std::runtime_error(fmt::format(
        "{}: {} steers the vehicle of its mission, in real time; allowed without --speed max",
        rig.file, rig.mission.steering->from));
  return rig;
}

template <class Result>
auto or_throw(Result result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

pipeline::Pipeline pipeline_in_step(const rig_config::Rig& rig, setup::Outside outside,
                                    pipeline::EstimateListener& listener) {
  outside.lockstep = true;
  outside.devices = host::bus_devices(rig);
  return or_throw(pipeline::make_pipeline(setup::pipeline_options(rig, &outside), listener));
}

/// The clocks of the devices whose links are recordings; the others' are of no use.
std::vector<shell::RecordingClock> recordings_of(
    const std::vector<std::unique_ptr<device::Device>>& drivers) {
  std::vector<shell::RecordingClock> clocks(drivers.size());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const auto uri = link::parse_uri(drivers[i]->options().link);
    if (uri && uri->recorded())
      clocks[i] = shell::clock_of(*uri, drivers[i]->options().driver, drivers[i]->travels());
  }
  return clocks;
}

}  // namespace

/// Passes what a driver sends to the raw listener and to the emulated other end of its link.
class LockstepBench::ToLine final : public device::Transmitter {
 public:
  ToLine(const shell::Lockstep& clock, std::string link, shell::RawListener& raw)
      : clock_(clock), link_(std::move(link)), raw_(raw) {}
  void send(wire::Bytes bytes) override {
    raw_.on_bytes(link_, shell::Direction::sent, bytes, clock_.now());
    if (line != nullptr) line->receive(bytes, clock_.now());
  }
  void send(const wire::CanFrame& frame) override {
    raw_.on_frame(link_, shell::Direction::sent, frame, clock_.now());
    if (bus != nullptr) bus->receive(frame, clock_.now());
  }
  emulate::EmulatedLine* line = nullptr;
  emulate::EmulatedBus* bus = nullptr;

 private:
  const shell::Lockstep& clock_;
  std::string link_;
  shell::RawListener& raw_;
};

LockstepBench::LockstepBench(const rig_config::Rig& rig, const motion::Trajectory& motion,
                             host::Follower& follower,
                             emulate::RealTimeEmulator::OnWritten on_written,
                             setup::Outside outside)
    : rig_(not_steered_by_a_program(rig)),
      follower_(follower),
      on_written_(std::move(on_written)),
      start_(motion.start()),
      clock_(start_),
      faults_(rig, motion, start_),
      teller_(follower),
      pipeline_(pipeline_in_step(rig, outside, teller_)) {
  auto drivers = or_throw(shell::make_devices(rig));
  const auto recordings = recordings_of(drivers);
  const auto starts = shell::recorded_starts(recordings, start_);
  for (std::size_t i = 0; i < drivers.size(); ++i)
    add(rig.devices[i], std::move(drivers[i]), recordings[i], starts[i]);
  for (auto& bus : buses_) clock_.add(*bus.second.bus);
  if (pilot::is_wanted(rig)) add_pilot(std::move(outside.say));
}

LockstepBench::~LockstepBench() = default;

void LockstepBench::set_fault(const rig_config::FaultConfig& fault) {
  if (const auto set = faults_.set(fault, now()); !set)
    throw std::runtime_error(set.error().front().what);
  for (auto& bus : buses_) bus.second.bus->faults_changed();
}

void LockstepBench::add_pilot(setup::Outside::Say say) {
  pilot_ = std::make_unique<PilotInStep>(
      rig_, start_,
      [this](const std::string& link, const wire::CanFrame& frame) {
        follower_.on_frame(link, shell::Direction::sent, frame, clock_.now());
        if (const auto bus = buses_.find(link); bus != buses_.end())
          bus->second.bus->receive(frame, clock_.now());
      },
      say ? std::move(say) : [](const std::string&) {});
  clock_.add(*pilot_);
}

void LockstepBench::add(const rig_config::DeviceConfig& config,
                        std::unique_ptr<device::Device> device, const shell::RecordingClock& clock,
                        measurement::Stamp begin) {
  const auto uri = link::parse_uri(config.link);
  if (!uri) throw std::runtime_error(uri.error().message);
  to_lines_.push_back(std::make_unique<ToLine>(clock_, config.link, follower_));
  device::Listener& listener = *this;
  actors_.push_back(std::make_unique<shell::DeviceActor>(
      std::move(device), listener, *to_lines_.back(), start_, host::provenance_of(config.link)));
  auto& actor = *actors_.back();
  clock_.add(actor);
  if (uri->recorded()) {
    actor.tap(follower_);
    if (actor.device().on_bus()) {
      recordings_.push_back(std::make_unique<shell::RecordedBus>(*uri, actor, begin, clock));
    } else {
      recordings_.push_back(std::make_unique<shell::RecordedLine>(*uri, actor, begin, clock));
    }
    clock_.add(*recordings_.back());
  } else if (!uri->emulated()) {
    throw std::runtime_error(fmt::format(
        "{}:{}: device \"{}\": {} is real hardware, which has no virtual time; "
        "allowed with --speed max: pty, memory, memory-can, can:auto, file, socketcan:vcan*",
        rig_.file, config.line, config.name, config.link));
  } else if (uri->carries() == link::Carries::bytes) {
    add_line(config, *uri, actor);
  } else {
    add_to_bus(config, *uri, actor);
  }
}

void LockstepBench::add_line(const rig_config::DeviceConfig& config, const link::Uri& uri,
                             shell::DeviceActor& actor) {
  lines_.push_back(std::make_unique<emulate::EmulatedLine>(
      or_throw(faults_.device(config)), uri.line_rate().value_or(emulate::without_line_rate),
      [this, &actor, name = config.name](wire::Bytes bytes, const emulate::Passage& passage) {
        if (on_written_) on_written_(name, passage, passage.ended_at);
        actor.receive(bytes, passage.ended_at);
      }));
  lines_.back()->set_on_told(
      [this, name = config.name](std::string_view what, Stamp at) { on_told_(name, what, at); });
  lines_.back()->set_on_port([&actor](bool there, Stamp at) { actor.set_port(there, at); });
  actor.tap(follower_);
  to_lines_.back()->line = lines_.back().get();
  clock_.add(*lines_.back());
}

void LockstepBench::add_to_bus(const rig_config::DeviceConfig& config, const link::Uri& uri,
                               shell::DeviceActor& actor) {
  auto& bus = buses_[config.link];
  if (!bus.bus) {
    bus.bus = std::make_unique<emulate::EmulatedBus>(
        uri.bitrate().value_or(default_bit_rate),
        [this, &bus, link = config.link](const wire::CanFrame& frame, std::size_t sender,
                                         const emulate::Passage& passage) {
          const Stamp at = passage.ended_at;
          if (on_written_) on_written_(bus.names.at(sender), passage, at);
          follower_.on_frame(link, shell::Direction::received, frame, at);
          for (auto* driver : bus.drivers) driver->receive(frame, at);
          if (pilot_) pilot_->receive(link, frame, at);
        });
  }
  bus.bus->add(or_throw(faults_.device(config)));
  bus.names.push_back(config.name);
  bus.bus->add(faults_.rogue(config, uri.bitrate().value_or(default_bit_rate)));
  bus.names.emplace_back();  // the frames of a rogue node belong to no device
  bus.drivers.push_back(&actor);
  to_lines_.back()->bus = bus.bus.get();
}

}  // namespace drydock::bench
