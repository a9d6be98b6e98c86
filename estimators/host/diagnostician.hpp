#pragma once

#include <vector>

#include "drivers/host/follower.hpp"
#include "rig_config/rig.hpp"

namespace drydock::diagnosis {
class Judge;
}

namespace drydock::host {

/// Follows a run and says what is wrong with which device. It tells the other followers its
/// findings. Add it after the publisher and before those who show findings.
class Diagnostician final : public Follower {
 public:
  /// Rig and followers must outlive the diagnostician.
  Diagnostician(const rig_config::Rig& rig, Follower& to);
  ~Diagnostician() override;

  /// The drivers whose health it looks at; they must outlive it. Without them it sees only
  /// measurements and frames.
  void watch(std::vector<const device::Device*> devices);

  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override;
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_health(const HealthReport&, Stamp now) override { look(now); }
  void on_late_wake(Stamp due, Stamp woke) override;

  /// Looks at the drivers and weighs what the monitors saw. It is called on measurements and on
  /// health; a caller with a clock may call it more often.
  void look(Stamp now);

  /// Nobody calls before `until`, and that is no stall.
  void await(Stamp until) { called_ = until; }

  const diagnosis::Judge& judge() const;

 private:
  class Bench;  ///< the monitors and the judge

  /// Where the host's clock was set, all that the monitors know refers to another time: they begin
  /// anew, and findings end at the old time. The followers are told.
  void follow_clock(Stamp now);
  /// Somebody calls at least once a second. Where nobody did, this program or the computer stood
  /// still, or the recording has a hole: that says nothing about a sensor. The followers are told.
  void notice_stall(Stamp now);

  const rig_config::Rig& rig_;
  Follower& to_;
  std::vector<const device::Device*> devices_;
  std::vector<std::chrono::nanoseconds> moved_;  ///< by which each device knows that it was set
  std::chrono::nanoseconds all_moved_{0};
  std::optional<Stamp> called_;  ///< the last time
  std::unique_ptr<Bench> bench_;
};

}  // namespace drydock::host
