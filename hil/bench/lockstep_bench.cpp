#include "hil/bench/lockstep_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/host/rig_bus.hpp"
#include "drivers/shell/recorded_starts.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/joint_troubles.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "rig_config/steering.hpp"

namespace drydock::bench {
namespace {

using measurement::Stamp;

constexpr unsigned default_bit_rate = 250'000;

/// Who steers by messages has a clock of its own.
const rig_config::Rig& not_steered_in_real_time(const rig_config::Rig& rig) {
  const auto& mission = rig.mission;
  if (mission.steering && !rig_config::steered_over_wires(mission) &&
      !rig_config::steered_by_program(mission))
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
    : rig_(not_steered_in_real_time(rig)),
      follower_(follower),
      on_written_(std::move(on_written)),
      start_(motion.start()),
      clock_(start_),
      faults_(rig, motion, start_),
      teller_(follower),
      pipeline_(pipeline_in_step(rig, outside, teller_)) {
  auto drivers = or_throw(shell::make_devices(rig));
  const auto files = shell::played_files(drivers);
  const auto starts = shell::recorded_starts(files, start_);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    add(rig.devices[i], std::move(drivers[i]));
    for (std::size_t file = 0; file < files.size(); ++file)
      if (files[file].devices.back() == i) play(files[file], starts[file]);
  }
  for (auto& bus : buses_) clock_.add(*bus.second.bus);
  if (rig_config::steered_by_program(rig.mission))
    add_program(motion, std::move(outside.say));
  else if (pilot::is_wanted(rig))
    add_pilot(std::move(outside.say));
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

void LockstepBench::add_program(const motion::Trajectory& motion, setup::Outside::Say say) {
  auto* steered = motion::steered_behind(motion);
  if (steered == nullptr)
    throw std::runtime_error(rig_.file + ": a program cannot steer the motion of this run");
  program_ = std::make_unique<ProgramInStep>(
      rig_, *steered, [this](Stamp at) { return joint_troubles(rig_, faults_, at); },
      say ? std::move(say) : [](const std::string&) {});
  clock_.add(*program_);
}

void LockstepBench::stop() {
  stopping_ = true;
  for (const auto& actor : actors_) actor->stop(now());
}

bool LockstepBench::is_played() const {
  return lines_.empty() && buses_.empty() && std::ranges::none_of(recordings_, [](const auto& one) {
           return one->deadline().has_value();
         });
}

void LockstepBench::play(const shell::PlayedFile& file, Stamp begin) {
  std::vector<shell::DeviceActor*> readers;
  for (const std::size_t i : file.devices) readers.push_back(actors_[i].get());
  readers.front()->tap(follower_);
  recordings_.push_back(shell::player_of(file, std::move(readers), begin));
  clock_.add(*recordings_.back());
}

void LockstepBench::add(const rig_config::DeviceConfig& config,
                        std::unique_ptr<device::Device> device) {
  const auto uri = link::parse_uri(config.link);
  if (!uri) throw std::runtime_error(uri.error().message);
  to_lines_.push_back(std::make_unique<ToLine>(clock_, config.link, follower_));
  device::Listener& listener = *this;
  actors_.push_back(std::make_unique<shell::DeviceActor>(
      std::move(device), listener, *to_lines_.back(), start_, host::provenance_of(config.link)));
  auto& actor = *actors_.back();
  clock_.add(actor);
  if (uri->recorded()) return;  // play() waits for all devices on it
  if (!uri->emulated()) {
    throw std::runtime_error(fmt::format(
        "{}:{}: device \"{}\": {} is real hardware, which has no virtual time; "
        "allowed with --speed max: pty, memory, memory-can, can:auto, file, socketcan:vcan*",
        rig_.file, config.line, config.name, config.link));
  } else if (uri->carries() == link::Carries::bytes) {
    add_to_line(config, *uri, actor);
  } else {
    add_to_bus(config, *uri, actor);
  }
}

/// The devices of one line name it with the same words.
void LockstepBench::add_to_line(const rig_config::DeviceConfig& config, const link::Uri& uri,
                                shell::DeviceActor& actor) {
  auto device = or_throw(faults_.device(config));
  auto [known, is_new] = lines_.try_emplace(config.link);
  Line& line = known->second;
  if (is_new) {
    auto devices = std::make_unique<emulate::LineSharers>();
    line.devices = devices.get();
    line.line = make_line(line, std::move(devices), uri);
    clock_.add(*line.line);
    actor.tap(follower_);
  } else {
    actor.share_link();
    line.drivers.front()->share_link();
  }
  line.devices->add(config.name, std::move(device));
  line.drivers.push_back(&actor);
  to_lines_.back()->line = line.line.get();
}

std::unique_ptr<emulate::EmulatedLine> LockstepBench::make_line(
    Line& line, std::unique_ptr<emulate::LineSharers> devices, const link::Uri& uri) {
  auto made = std::make_unique<emulate::EmulatedLine>(
      std::move(devices), uri.line_rate().value_or(emulate::without_line_rate),
      [this, &line](wire::Bytes bytes, const emulate::Passage& passage) {
        if (on_written_)
          on_written_(line.devices->name_of(passage.sender), passage, passage.ended_at);
        for (auto* driver : line.drivers) driver->receive(bytes, passage.ended_at);
      });
  made->set_on_told([this, &line](std::string_view what, Stamp at) {
    on_told_(line.devices->name_of(line.devices->sender()), what, at);
  });
  made->set_on_port([&line](bool there, Stamp at) {
    for (auto* driver : line.drivers) driver->set_port(there, at);
  });
  return made;
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
    bus.bus->set_on_told([this, &bus](std::size_t sender, std::string_view what, Stamp at) {
      on_told_(bus.names.at(sender), what, at);
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
