#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/lockstep.hpp"
#include "drivers/shell/played_files.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/setup/outside.hpp"
#include "hil/bench/pilot_in_step.hpp"
#include "hil/bench/program_in_step.hpp"
#include "hil/emulate/line_sharers.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/fault/injector.hpp"

namespace drydock::bench {

/// A rig in virtual time. Every link becomes a line inside this process with the same baud rate.
/// Measurements go from the drivers to the follower and then directly to the estimators.
class LockstepBench final : private device::Listener {
 public:
  /// Rig, motion and follower must outlive the bench. `on_written` gets what emulated devices send;
  /// may be empty. `outside`: how estimators in other programs are reached. Throws
  /// std::runtime_error with one line if a part of the rig cannot run in virtual time.
  LockstepBench(const rig_config::Rig& rig, const motion::Trajectory& motion,
                host::Follower& follower, emulate::RealTimeEmulator::OnWritten on_written = {},
                setup::Outside outside = {});
  ~LockstepBench() override;

  /// Called with what a driver has told an emulated device.
  using OnTold =
      std::function<void(std::string_view device, std::string_view what, measurement::Stamp at)>;
  void set_on_told(OnTold hook) { on_told_ = std::move(hook); }

  /// Acts in virtual time, behind the parts of the bench that are due at the same time. It must
  /// outlive the bench.
  void add(shell::Actor& actor) { clock_.add(actor); }

  measurement::Stamp now() const { return clock_.now(); }
  void run_until(measurement::Stamp end) { clock_.run_until(end); }
  void flush() { pipeline_.flush(); }  ///< call it at the end of a run
  /// Closes the devices, as a replay does at the end of its recording: what waits in a driver comes
  /// out. Nobody hears that they close.
  void stop();

  /// Every link is a recording, and all of them are at their end.
  bool is_played() const;

  std::size_t devices() const { return actors_.size(); }
  const device::Device& device(std::size_t i) const { return actors_[i]->device(); }
  pipeline::Pipeline& pipeline() { return pipeline_; }
  const pipeline::Pipeline& pipeline() const { return pipeline_; }
  fault::Injector& faults() { return faults_; }
  /// Null: no program steers the vehicle.
  const ProgramInStep* program() const { return program_.get(); }
  /// Sets a fault by hand; its times count from now. Throws std::runtime_error with one line if the
  /// device cannot have it.
  void set_fault(const rig_config::FaultConfig& fault);

 private:
  class ToLine;
  struct Line {
    std::unique_ptr<emulate::EmulatedLine> line;
    emulate::LineSharers* devices = nullptr;  ///< at its end
    std::vector<shell::DeviceActor*> drivers;
  };
  struct Bus {
    std::unique_ptr<emulate::EmulatedBus> bus;
    std::vector<std::string> names;  ///< its emulated nodes
    std::vector<shell::DeviceActor*> drivers;
  };

  void add(const rig_config::DeviceConfig& config, std::unique_ptr<device::Device> device);
  void play(const shell::PlayedFile& file, measurement::Stamp begin);
  void add_to_line(const rig_config::DeviceConfig& config, const link::Uri& uri,
                   shell::DeviceActor& actor);
  std::unique_ptr<emulate::EmulatedLine> make_line(Line& line,
                                                   std::unique_ptr<emulate::LineSharers> devices,
                                                   const link::Uri& uri);
  void add_pilot(setup::Outside::Say say);
  void add_program(const motion::Trajectory& motion, setup::Outside::Say say);
  void add_to_bus(const rig_config::DeviceConfig& config, const link::Uri& uri,
                  shell::DeviceActor& actor);

  void on_measurement(const measurement::Measurement& m) override {
    follower_.on_measurement(m);
    if (pilot_) pilot_->receive(m);
    if (program_) program_->receive(m);
    pipeline_.receive(m);
  }
  void on_state(const device::Device& device, const device::Transition& change) override {
    if (!stopping_) follower_.on_state(device, change);
  }

  const rig_config::Rig& rig_;
  host::Follower& follower_;
  emulate::RealTimeEmulator::OnWritten on_written_;
  OnTold on_told_ = [](std::string_view, std::string_view, measurement::Stamp) {};
  measurement::Stamp start_;
  bool stopping_ = false;
  shell::Lockstep clock_;
  fault::Injector faults_;
  host::EstimateTeller teller_;
  pipeline::Pipeline pipeline_;
  std::vector<std::unique_ptr<ToLine>> to_lines_;
  std::vector<std::unique_ptr<shell::DeviceActor>> actors_;
  std::map<std::string, Line> lines_;
  std::vector<std::unique_ptr<shell::Actor>> recordings_;  ///< one for each file
  std::map<std::string, Bus> buses_;
  std::unique_ptr<PilotInStep> pilot_;      ///< null: nobody steers over the wires
  std::unique_ptr<ProgramInStep> program_;  ///< null: no program steers
};

}  // namespace drydock::bench
