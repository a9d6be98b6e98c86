#pragma once

#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::host {

/// Follows a run, in addition to the bus: a recording, a viewer. It never waits and never throws.
class Watcher : public shell::RawListener {
 public:
  using Stamp = measurement::Stamp;

  void on_bytes(std::string_view, shell::Direction, wire::Bytes, Stamp) override {}
  void on_frame(std::string_view, shell::Direction, const wire::CanFrame&, Stamp) override {}
  virtual void note(const measurement::Measurement& measurement) = 0;
  /// `estimator` is the index in the rig; the index after the last estimator is the truth.
  virtual void note(const bus::Attitude& attitude, std::size_t estimator) = 0;
  virtual void note(const bus::Navigation& navigation, std::size_t estimator) = 0;
  virtual void note(std::span<const bus::DeviceStatus> health, Stamp now) = 0;
  virtual void note(const bus::Innovation&) {}
  /// Called whenever the faults in force change. `faults` holds all faults in force now; ended
  /// faults are not in it.
  virtual void note(std::span<const bus::Fault> /*faults*/, Stamp /*now*/) {}
  virtual void tick(Stamp now) = 0;  ///< a few times a second
};

/// All watchers of one run.
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
