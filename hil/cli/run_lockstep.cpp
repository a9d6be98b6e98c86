#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <stdexcept>

#include "drivers/cli/rig_bus.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/lockstep.hpp"
#include "drivers/shell/recorded_bus.hpp"
#include "drivers/shell/recorded_line.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/cli/rig_pipeline.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/cli/expect_watch.hpp"
#include "hil/cli/fault/live_faults.hpp"
#include "hil/cli/interrupt_flag.hpp"
#include "hil/cli/run.hpp"
#include "hil/cli/run_watchers.hpp"
#include "hil/cli/scribe.hpp"
#include "hil/cli/truth_of_rig.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/fault/chronicle.hpp"
#include "hil/motion/remembered_trajectory.hpp"

namespace drydock::cli {
namespace {

using measurement::Stamp;

constexpr unsigned default_bit_rate = 250'000;

template <class Result>
auto or_throw(Result result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// What a driver sends goes to whatever emulates its other end, and past the watchers.
class ToLine final : public device::Transmitter {
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

/// A rig in virtual time: every link becomes a line of this process with the same baud rate.
class LockstepBench final : private device::Listener, private pipeline::EstimateListener {
 public:
  LockstepBench(const rig_config::Rig& rig, const RunOptions& options)
      : rig_(rig),
        on_measurement_hook_(options.on_measurement),
        each_second_(options.each_second),
        quiet_(options.quiet),
        on_written_hook_(options.on_written),
        start_(measurement::stamp_from_ns(rig.start_utc_ns)),
        trajectory_(std::make_unique<motion::RememberedTrajectory>(
            motion::make_trajectory(rig.mission, start_))),
        clock_(start_),
        faults_(rig, *trajectory_, start_),
        chronicle_(faults_, start_),
        pipeline_(or_throw(pipeline::make_pipeline(pipeline_options(rig), *this))),
        duration_s_(options.duration_s > 0 ? options.duration_s
                                           : measurement::seconds(trajectory_->end() - start_)),
        scribe_(rig, truth_for_estimators(rig) ? trajectory_.get() : nullptr, start_, duration_s_,
                options.curve_points),
        expects_(rig, truth_for_estimators(rig) ? trajectory_.get() : nullptr, start_),
        watchers_(rig, truth_for_estimators(rig) ? trajectory_.get() : nullptr) {
    if (!quiet_ && ::isatty(STDOUT_FILENO) != 1)
      chronicle_.set_on_change([this](const fault::Episode& episode) {
        fmt::print("{}\n", line_of(episode, start_));
      });
    if (!options.record.path.empty()) {
      recorder_.emplace(rig, options.record, start_, record::WhenBehind::wait);
      watchers_.all.add(*recorder_);
    }
    auto devices = or_throw(shell::make_devices(rig));
    for (std::size_t i = 0; i < devices.size(); ++i) add(rig.devices[i], std::move(devices[i]));
    for (auto& bus : buses_) clock_.add(*bus.second.bus);
  }

  Summary run() {
    const InterruptFlag interrupted;
    const auto wall_start = std::chrono::steady_clock::now();
    const Stamp end = start_ + measurement::from_seconds(duration_s_);
    scribe_.follow(start_);
    while (clock_.now() < end && !interrupted.set()) {
      clock_.run_until(std::min(end, clock_.now() + std::chrono::seconds{1}));
      scribe_.follow(clock_.now());
      chronicle_.follow(clock_.now());
      expects_.follow(
          clock_.now(), [this] { return devices(); }, pipeline_);
      tell_watchers();
      if (each_second_) each_second_({clock_.now(), devices_, faults_});
      show_progress();
    }
    pipeline_.flush();
    Summary s;
    s.rig = rig_.name;
    s.mode = "lockstep";
    s.seed = rig_.seed;
    s.duration_s = measurement::seconds(clock_.now() - start_);
    s.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
    s.interrupted = interrupted.set();
    s.devices = devices();
    s.notes = pipeline_notes(rig_, pipeline_);
    if (recorder_) s.notes.push_back(recorder_->finish());
    scribe_.write(s);
    expects_.write(s, pipeline_);
    cli::write(chronicle_, start_, s);
    return s;
  }

 private:
  struct Bus {
    std::unique_ptr<emulate::EmulatedBus> bus;
    std::vector<std::string> names;  ///< of its emulated nodes
    std::vector<shell::DeviceActor*> drivers;
  };

  std::vector<DeviceSummary> devices() const {
    std::vector<DeviceSummary> all;
    for (const auto& actor : actors_) {
      const auto& device = actor->device();
      all.push_back(
          summarise(device, device.health(clock_.now()), provenance_of(device.options().link)));
    }
    return all;
  }

  void add(const rig_config::DeviceConfig& config, std::unique_ptr<device::Device> device) {
    const auto uri = link::parse_uri(config.link);
    if (!uri) throw std::runtime_error(uri.error().message);
    to_lines_.push_back(std::make_unique<ToLine>(clock_, config.link, watchers_.all));
    device::Listener& listener = *this;
    actors_.push_back(std::make_unique<shell::DeviceActor>(
        std::move(device), listener, *to_lines_.back(), start_, provenance_of(config.link)));
    auto& actor = *actors_.back();
    devices_.push_back(&actor.device());
    clock_.add(actor);
    if (uri->recorded()) {
      actor.tap(watchers_.all);
      if (actor.device().on_bus()) {
        recordings_.push_back(std::make_unique<shell::RecordedBus>(*uri, actor, start_));
      } else {
        recordings_.push_back(std::make_unique<shell::RecordedLine>(*uri, actor, start_));
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

  void add_line(const rig_config::DeviceConfig& config, const link::Uri& uri,
                shell::DeviceActor& actor) {
    lines_.push_back(std::make_unique<emulate::EmulatedLine>(
        or_throw(faults_.device(config)), uri.baud().value_or(emulate::without_line_rate),
        [this, &actor, name = config.name](wire::Bytes bytes, const emulate::Passage& passage) {
          if (on_written_hook_) on_written_hook_(name, passage, passage.ended_at);
          actor.receive(bytes, passage.ended_at);
        }));
    lines_.back()->set_on_port([&actor](bool there, Stamp at) { actor.set_port(there, at); });
    actor.tap(watchers_.all);
    to_lines_.back()->line = lines_.back().get();
    clock_.add(*lines_.back());
  }

  void add_to_bus(const rig_config::DeviceConfig& config, const link::Uri& uri,
                  shell::DeviceActor& actor) {
    auto& bus = buses_[config.link];
    if (!bus.bus) {
      bus.bus = std::make_unique<emulate::EmulatedBus>(
          uri.bitrate().value_or(default_bit_rate),
          [this, &bus, link = config.link](const wire::CanFrame& frame, std::size_t sender,
                                           const emulate::Passage& passage) {
            const Stamp at = passage.ended_at;
            if (on_written_hook_) on_written_hook_(bus.names.at(sender), passage, at);
            watchers_.all.on_frame(link, shell::Direction::received, frame, at);
            for (auto* driver : bus.drivers) driver->receive(frame, at);
          });
    }
    bus.bus->add(or_throw(faults_.device(config)));
    bus.names.push_back(config.name);
    if (has_faults(config)) {
      bus.bus->add(faults_.rogue(config, uri.bitrate().value_or(default_bit_rate)));
      bus.names.emplace_back();
    }
    bus.drivers.push_back(&actor);
    to_lines_.back()->bus = bus.bus.get();
  }

  bool has_faults(const rig_config::DeviceConfig& config) const {
    return each_second_ || std::ranges::find(rig_.faults, config.name,
                                             &rig_config::FaultConfig::device) != rig_.faults.end();
  }

  void on_measurement(const measurement::Measurement& m) override {
    scribe_.note(m);
    watchers_.all.note(m);
    pipeline_.receive(m);
    if (on_measurement_hook_) on_measurement_hook_(m);
  }

  void on_state(const device::Device& device, const device::Transition& change) override {
    expects_.note(device.name(), change);
    if (quiet_ || ::isatty(STDOUT_FILENO) == 1) return;
    fmt::print("{:.3f} s {}: {} -> {}: {}\n", measurement::seconds(change.at - start_),
               device.name(), to_string(change.from), to_string(change.to), change.why.view());
  }

  void on_attitude(const pipeline::AttitudeEstimate& estimate) override {
    scribe_.note(estimate);
    expects_.note(estimate);
    watchers_.note(estimate);
  }
  void on_navigation(const pipeline::NavigationEstimate& estimate) override {
    scribe_.note(estimate);
    expects_.note(estimate);
    watchers_.note(estimate);
  }

  void on_innovation(const pipeline::InnovationReport& report) override { watchers_.note(report); }

  void tell_watchers() {
    if (watchers_.all.empty()) return;
    tell_faults();
    std::vector<bus::DeviceStatus> health;
    for (const auto& actor : actors_)
      health.push_back(status_of(actor->device(), actor->device().health(clock_.now())));
    watchers_.all.note(health, clock_.now());
    watchers_.all.tick(clock_.now());
  }

  void tell_faults() {
    auto now = faults_.in_force(clock_.now());
    if (now == faults_told_) return;
    tell_faults_to(watchers_.all, now, clock_.now());
    faults_told_ = std::move(now);
  }

  void show_progress() const {
    if (::isatty(STDOUT_FILENO) != 1) return;
    const double done = measurement::seconds(clock_.now() - start_);
    fmt::print("\r{:.0f} s of {:.0f} s ({:.0f} %)", done, duration_s_, 100 * done / duration_s_);
    std::fflush(stdout);
  }

  const rig_config::Rig& rig_;
  std::function<void(const measurement::Measurement&)> on_measurement_hook_;
  std::function<void(const RunView&)> each_second_;
  bool quiet_;
  OnWritten on_written_hook_;
  Stamp start_;
  std::unique_ptr<motion::Trajectory> trajectory_;
  shell::Lockstep clock_;
  fault::Injector faults_;
  std::vector<fault::FaultNow> faults_told_;
  fault::Chronicle chronicle_;
  pipeline::Pipeline pipeline_;
  double duration_s_;
  Scribe scribe_;
  ExpectWatch expects_;
  RunWatchers watchers_;
  std::optional<RigRecorder> recorder_;
  std::vector<std::unique_ptr<ToLine>> to_lines_;
  std::vector<std::unique_ptr<shell::DeviceActor>> actors_;
  std::vector<const device::Device*> devices_;
  std::vector<std::unique_ptr<emulate::EmulatedLine>> lines_;
  std::vector<std::unique_ptr<shell::Actor>> recordings_;
  std::map<std::string, Bus> buses_;
};

}  // namespace

Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options) {
  LockstepBench bench(rig, options);
  return bench.run();
}

}  // namespace drydock::cli
