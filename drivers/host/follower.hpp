#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/device/device.hpp"
#include "drivers/diagnosis/finding.hpp"
#include "drivers/host/health_report.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::host {

/// The steady current that an estimator found, with one standard deviation. It is not on the bus.
struct Current {
  Eigen::Vector2d north_east_mps = Eigen::Vector2d::Zero(), sigma_mps = Eigen::Vector2d::Zero();
};

/// One estimate, or the truth at one time.
struct Estimate {
  std::size_t estimator = 0;  ///< index in the rig; the truth has none
  bus::Attitude attitude;
  std::optional<bus::Navigation> navigation{};  ///< only from an estimator that navigates
  std::optional<Current> current{};             ///< empty if not estimated
  bus::Integrity integrity{};                   ///< the truth is always valid
};

/// Sees everything that happens in a run: recording, page, bus, report, expectations and lines on
/// the terminal are followers. A follower overrides what it needs. It never waits, unless told to,
/// and never throws.
class Follower : public shell::RawListener, public device::Listener {
 public:
  using Stamp = measurement::Stamp;

  void on_bytes(std::string_view, shell::Direction, wire::Bytes, Stamp) override {}
  void on_frame(std::string_view, shell::Direction, const wire::CanFrame&, Stamp) override {}
  void on_measurement(const measurement::Measurement&) override {}
  void on_state(const device::Device&, const device::Transition&) override {}
  virtual void on_estimate(const Estimate&) {}
  virtual void on_innovation(const bus::Innovation&) {}
  /// The truth of an emulated vehicle comes before an estimate of its time, at most once in 40 ms,
  /// and between estimates as often.
  virtual void on_truth(const Estimate&) {}
  virtual void on_health(const HealthReport&, Stamp /*now*/) {}  ///< once a second
  /// Called when the faults in force change. `faults` holds all faults that are in force now.
  virtual void on_faults(std::span<const bus::Fault>, Stamp /*now*/) {}
  /// Called when a finding begins and again when it is over (`until`).
  virtual void on_finding(const diagnosis::Finding&) {}
  /// Somebody set the host's clock by `step`: all stamps told so far are of the old time.
  virtual void on_clock_step(std::chrono::nanoseconds /*step*/) {}
  /// This program or the computer stood still, or the recording has a hole: all lines fell silent,
  /// and that was no fault of a sensor.
  virtual void on_stall(Stamp /*from*/, Stamp /*to*/) {}
  /// This computer was busy: this program should have woken at `due` and did at `woke`. What its
  /// links brought meanwhile, which is told behind this, has a late time.
  virtual void on_late_wake(Stamp /*due*/, Stamp /*woke*/) {}
  virtual void tick(Stamp /*now*/) {}  ///< a few times a second; in virtual time once a second
};

/// All followers of one run, in the order in which they are told.
class Followers final : public Follower {
 public:
  /// The follower must outlive the run.
  void add(Follower& follower) { all_.push_back(&follower); }

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    for (auto* follower : all_) follower->on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    for (auto* follower : all_) follower->on_frame(link, way, frame, at);
  }
  void on_measurement(const measurement::Measurement& measurement) override {
    for (auto* follower : all_) follower->on_measurement(measurement);
  }
  void on_state(const device::Device& device, const device::Transition& change) override {
    for (auto* follower : all_) follower->on_state(device, change);
  }
  void on_estimate(const Estimate& estimate) override {
    for (auto* follower : all_) follower->on_estimate(estimate);
  }
  void on_innovation(const bus::Innovation& innovation) override {
    for (auto* follower : all_) follower->on_innovation(innovation);
  }
  void on_truth(const Estimate& truth) override {
    for (auto* follower : all_) follower->on_truth(truth);
  }
  void on_health(const HealthReport& health, Stamp now) override {
    for (auto* follower : all_) follower->on_health(health, now);
  }
  void on_faults(std::span<const bus::Fault> faults, Stamp now) override {
    for (auto* follower : all_) follower->on_faults(faults, now);
  }
  void on_finding(const diagnosis::Finding& finding) override {
    for (auto* follower : all_) follower->on_finding(finding);
  }
  void on_clock_step(std::chrono::nanoseconds step) override {
    for (auto* follower : all_) follower->on_clock_step(step);
  }
  void on_stall(Stamp from, Stamp to) override {
    for (auto* follower : all_) follower->on_stall(from, to);
  }
  void on_late_wake(Stamp due, Stamp woke) override {
    for (auto* follower : all_) follower->on_late_wake(due, woke);
  }
  void tick(Stamp now) override {
    for (auto* follower : all_) follower->tick(now);
  }

 private:
  std::vector<Follower*> all_;
};

}  // namespace drydock::host
