#pragma once

#include <string>
#include <vector>

#include "drivers/diagnosis/bus_monitor.hpp"
#include "drivers/diagnosis/device_monitor.hpp"
#include "drivers/diagnosis/judge.hpp"
#include "drivers/host/follower.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Follows a run and says what is wrong with which device. It tells the other followers its
/// findings. Add it after the publisher and before those who show findings.
class Diagnostician final : public Follower, private diagnosis::FindingListener {
 public:
  /// Rig and followers must outlive the diagnostician.
  Diagnostician(const rig_config::Rig& rig, Follower& to);

  /// The drivers whose health it looks at, in the order of the rig; they must outlive it. Without
  /// them it sees only measurements.
  void watch(std::vector<const device::Device*> devices);

  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override;
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_health(const HealthReport&, Stamp now) override { look(now); }

  /// Looks at the drivers and weighs what the monitors saw. It is called on measurements and on
  /// health; a caller with a clock may call it more often.
  void look(Stamp now);

  const diagnosis::Judge& judge() const { return judge_; }

 private:
  struct Bus {
    std::string link;
    diagnosis::BusMonitor monitor;
    std::size_t device;  ///< one that is on it
  };
  struct Line {
    std::string link;
    double rate_hz = 0;  ///< of all its devices
    Stamp last{};
  };
  void add_buses(const rig_config::Rig& rig);
  void notice_stall(std::size_t device, Stamp now);
  void notice_depth(const measurement::DepthSample& sample, std::size_t device);

  void on_finding(const diagnosis::Finding& finding) override { to_.on_finding(finding); }

  Follower& to_;
  diagnosis::Judge judge_;
  std::vector<diagnosis::DeviceMonitor> monitors_;
  std::vector<const device::Device*> devices_;
  std::vector<Bus> buses_;
  std::vector<Line> lines_;           ///< each link once
  std::vector<std::size_t> line_of_;  ///< of each device
  std::vector<double> down_m_;        ///< of each device below the vehicle's origin
  Stamp next_look_{}, last_{};
};

}  // namespace drydock::host
