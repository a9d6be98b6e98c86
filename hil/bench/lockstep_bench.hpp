#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/lockstep.hpp"
#include "drivers/shell/raw_listener.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/fault/injector.hpp"

namespace drydock::bench {

/// A rig in virtual time. Every link becomes a line inside this process with the same baud rate.
/// Measurements go from the drivers to `devices` and then directly to the estimators.
class LockstepBench final : private device::Listener {
 public:
  /// The listeners of a bench.
  struct Listeners {
    device::Listener& devices;
    pipeline::EstimateListener& estimates;
    shell::RawListener& raw;  ///< sees every byte and frame
    emulate::RealTimeEmulator::OnWritten on_written =
        {};  ///< gets what emulated devices sent; may be empty
  };

  /// All arguments must outlive the bench. Throws std::runtime_error with one line if a part of the
  /// rig cannot run in virtual time.
  LockstepBench(const rig_config::Rig& rig, const motion::Trajectory& motion,
                const Listeners& listeners);
  ~LockstepBench() override;

  measurement::Stamp now() const { return clock_.now(); }
  void run_until(measurement::Stamp end) { clock_.run_until(end); }
  void flush() { pipeline_.flush(); }  ///< call it at the end of a run

  std::size_t devices() const { return actors_.size(); }
  const device::Device& device(std::size_t i) const { return actors_[i]->device(); }
  const pipeline::Pipeline& pipeline() const { return pipeline_; }
  fault::Injector& faults() { return faults_; }

 private:
  class ToLine;
  struct Bus {
    std::unique_ptr<emulate::EmulatedBus> bus;
    std::vector<std::string> names;  ///< its emulated nodes
    std::vector<shell::DeviceActor*> drivers;
  };

  void add(const rig_config::DeviceConfig& config, std::unique_ptr<device::Device> device);
  void add_line(const rig_config::DeviceConfig& config, const link::Uri& uri,
                shell::DeviceActor& actor);
  void add_to_bus(const rig_config::DeviceConfig& config, const link::Uri& uri,
                  shell::DeviceActor& actor);

  void on_measurement(const measurement::Measurement& m) override;
  void on_state(const device::Device& device, const device::Transition& change) override;

  const rig_config::Rig& rig_;
  device::Listener& listener_;
  shell::RawListener& raw_;
  emulate::RealTimeEmulator::OnWritten on_written_;
  measurement::Stamp start_;
  shell::Lockstep clock_;
  fault::Injector faults_;
  pipeline::Pipeline pipeline_;
  std::vector<std::unique_ptr<ToLine>> to_lines_;
  std::vector<std::unique_ptr<shell::DeviceActor>> actors_;
  std::vector<std::unique_ptr<emulate::EmulatedLine>> lines_;
  std::vector<std::unique_ptr<shell::Actor>> recordings_;
  std::map<std::string, Bus> buses_;
};

}  // namespace drydock::bench
