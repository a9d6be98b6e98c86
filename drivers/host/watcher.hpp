#pragma once

#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::host {

/// Follows a run beside drivers and bus: a recording, a viewer. Never waits, never throws.
class Watcher : public shell::RawListener {
 public:
  using Stamp = measurement::Stamp;

  void on_bytes(std::string_view, shell::Direction, wire::Bytes, Stamp) override {}
  void on_frame(std::string_view, shell::Direction, const wire::CanFrame&, Stamp) override {}
  virtual void note(const measurement::Measurement& measurement) = 0;
  /// `estimator` counts as the rig does; the one after the last is the truth.
  virtual void note(const bus::Attitude& attitude, std::size_t estimator) = 0;
  virtual void note(const bus::Navigation& navigation, std::size_t estimator) = 0;
  virtual void note(std::span<const bus::DeviceStatus> health, Stamp now) = 0;
  virtual void note(const bus::Innovation&) {}
  /// Whenever the faults in force change: all that are in force now, none that have ended.
  virtual void note(std::span<const bus::Fault> /*faults*/, Stamp /*now*/) {}
  virtual void tick(Stamp now) = 0;  ///< a few times a second
};

/// All that follow one run.
class Watchers final : public Watcher {
 public:
  void add(Watcher& watcher) { all_.push_back(&watcher); }
  bool empty() const { return all_.empty(); }

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    for (auto* watcher : all_) watcher->on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    for (auto* watcher : all_) watcher->on_frame(link, way, frame, at);
  }
  void note(const measurement::Measurement& measurement) override {
    for (auto* watcher : all_) watcher->note(measurement);
  }
  void note(const bus::Attitude& attitude, std::size_t estimator) override {
    for (auto* watcher : all_) watcher->note(attitude, estimator);
  }
  void note(const bus::Navigation& navigation, std::size_t estimator) override {
    for (auto* watcher : all_) watcher->note(navigation, estimator);
  }
  void note(std::span<const bus::DeviceStatus> health, Stamp now) override {
    for (auto* watcher : all_) watcher->note(health, now);
  }
  void note(const bus::Innovation& innovation) override {
    for (auto* watcher : all_) watcher->note(innovation);
  }
  void note(std::span<const bus::Fault> faults, Stamp now) override {
    for (auto* watcher : all_) watcher->note(faults, now);
  }
  void tick(Stamp now) override {
    for (auto* watcher : all_) watcher->tick(now);
  }

 private:
  std::vector<Watcher*> all_;
};

}  // namespace drydock::host
