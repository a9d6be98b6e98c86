#pragma once

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/watcher.hpp"

namespace drydock::replay {

/// Passes the messages of a rig's run to a sink, without the truth.
class TopicsWatcher final : public host::Watcher {
 public:
  /// The sink must outlive the watcher.
  TopicsWatcher(bus::CdrSink& sink, const rig_config::Rig& rig)
      : topics_(sink, host::bus_devices(rig), host::estimator_names(rig),
                host::navigator_names(rig)) {}

  using host::Watcher::note;
  void note(const measurement::Measurement& m) override { topics_.publish(m); }
  void note(const bus::Attitude& a, std::size_t i) override { topics_.publish(a, i); }
  void note(const bus::Navigation& n, std::size_t i) override { topics_.publish(n, i); }
  void note(std::span<const bus::DeviceStatus> health, Stamp now) override {
    topics_.publish(health, now);
  }
  void tick(Stamp) override {}

 private:
  bus::CdrPublisher topics_;
};

}  // namespace drydock::replay
