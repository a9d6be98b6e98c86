#pragma once

#include <vector>

#include "drivers/diagnosis/device_monitor.hpp"
#include "drivers/diagnosis/judge.hpp"
#include "drivers/host/follower.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Follows a run and says what is wrong with which device. It tells the other followers its
/// findings. Add it after the publisher and before those who show findings.
class Diagnostician final : public Follower {
 public:
  /// Rig and followers must outlive the diagnostician.
  Diagnostician(const rig_config::Rig& rig, Follower& to);

  /// The drivers whose health it looks at; they must outlive it. Without them it sees only
  /// measurements.
  void watch(std::vector<const device::Device*> devices) { devices_ = std::move(devices); }

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_health(const HealthReport&, Stamp now) override { look(now); }

  /// Looks at the drivers and weighs what the monitors saw. It is called on measurements and on
  /// health; a caller with a clock may call it more often.
  void look(Stamp now);

  const diagnosis::Judge& judge() const { return judge_; }

 private:
  /// It stands apart from the follower: the others hear findings, the diagnostician itself makes
  /// them.
  class Teller final : public diagnosis::FindingListener {
   public:
    explicit Teller(Follower& to) : to_(to) {}
    void on_finding(const diagnosis::Finding& finding) override { to_.on_finding(finding); }

   private:
    Follower& to_;
  };

  Teller teller_;
  diagnosis::Judge judge_;
  std::vector<diagnosis::DeviceMonitor> monitors_;
  std::vector<const device::Device*> devices_;
  Stamp next_look_{};
};

}  // namespace drydock::host
