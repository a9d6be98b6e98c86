#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::replay {

/// Faults between a recording and its drivers, in virtual time, on the links of the named devices.
/// While a fault is in force, received data pass frame by frame; otherwise they pass as they were
/// read. Links without a fault are not touched.
class ReplayFaults {
 public:
  using Stamp = measurement::Stamp;
  /// The drivers' side.
  struct Drivers {
    std::function<void(const record::RawEvent&)> hear;
    std::function<void(std::size_t link, bool there)> set_port;
  };

  /// Times count from the recording's first message. `played` lists the devices that have drivers.
  /// Throws std::runtime_error with a line for each fault that is not possible.
  ReplayFaults(const record::Recording& recording, const rig_config::Rig& rig,
               const std::vector<rig_config::FaultConfig>& faults,
               const std::vector<std::string>& played, Drivers drivers);
  ~ReplayFaults();
  ReplayFaults(const ReplayFaults&) = delete;
  ReplayFaults& operator=(const ReplayFaults&) = delete;

  bool are_on(std::size_t link) const { return first_[link] != nullptr; }
  void receive(const record::RawEvent& event);  ///< only for a link with are_on()
  std::optional<Stamp> deadline() const;
  void tick(Stamp now);

  /// One line per device, such as "dvl: drop 12".
  std::vector<std::string> lines() const;

  class Stage;  ///< one device on its link

 private:
  class End;

  void add(const record::Recording& recording, std::size_t link, Stamp start);

  rig_config::Rig rig_;  ///< with `faults` in place of its own faults, which the recording already
                         ///< shows
  std::optional<fault::Schedules> schedules_;
  Drivers drivers_;
  std::vector<std::unique_ptr<End>> ends_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::vector<Stage*> first_;  ///< by link; null: none
};

}  // namespace drydock::replay
