#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::replay {

/// Faults between a recording and its drivers, in virtual time: what the links of the named devices
/// received goes on as the faults let it, frame by frame while one is in force, and as it was read
/// while none is. Links without a fault are passed by.
class ReplayFaults {
 public:
  using Stamp = measurement::Stamp;
  /// The drivers' side.
  struct Drivers {
    std::function<void(const record::RawEvent&)> hear;
    std::function<void(std::size_t link, bool there)> set_port;
  };

  /// Times count from the recording's first message. `played` are the devices that have drivers.
  /// Throws std::runtime_error with a line for each fault that cannot be.
  ReplayFaults(const record::Recording& recording, const rig_config::Rig& rig,
               const std::vector<rig_config::FaultConfig>& faults,
               const std::vector<std::string>& played, Drivers drivers);
  ~ReplayFaults();
  ReplayFaults(const ReplayFaults&) = delete;
  ReplayFaults& operator=(const ReplayFaults&) = delete;

  bool are_on(std::size_t link) const { return first_[link] != nullptr; }
  void receive(const record::RawEvent& event);  ///< of a link that they are on
  std::optional<Stamp> deadline() const;
  void tick(Stamp now);

  /// "dvl: drop 12", a line a device.
  std::vector<std::string> lines() const;

  class Stage;  ///< one device on its link

 private:
  class End;

  void add(const record::Recording& recording, std::size_t link, Stamp start);

  rig_config::Rig rig_;  ///< with these faults instead of its own, which are in the recording
  std::optional<fault::Schedules> schedules_;
  Drivers drivers_;
  std::vector<std::unique_ptr<End>> ends_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::vector<Stage*> first_;  ///< by link; empty: none
};

}  // namespace drydock::replay
