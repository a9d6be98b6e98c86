#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "drivers/shell/device_actor.hpp"
#include "rig_config/rig.hpp"

namespace drydock::record {

/// The drivers' part of the attached rig file. Mission and sensor files are not needed.
boost::system::result<rig_config::Rig, RecordingError> rig_of(const Recording& recording);

/// Runs the drivers of a recorded rig in the lockstep shell. They receive the recorded bytes and
/// frames and give the same measurements at the same times, bit for bit. Data that they send reach
/// nobody: the recording already contains the answers.
class Player final {
 public:
  /// Makes drivers for the selected devices on links of the recording. `sent` is told what they
  /// send, unless it is null. Both listeners must outlive the player.
  static boost::system::result<std::unique_ptr<Player>, RecordingError> make(
      const Recording& recording, const rig_config::Rig& rig, const Selection& selection,
      device::Listener& listener, shell::RawListener* sent = nullptr);

  /// A change of the host's clock can leave decades without a message. After a pause this long
  /// every driver has reached its time limits, so the rest of the pause is skipped.
  static constexpr std::chrono::hours longest_pause{1};

  /// Advances the time; drivers that waited for it act.
  void run_until(Stamp at);
  /// Advances the time to that of the event, and then gives the event to its devices. A sent event
  /// only advances the time.
  void play(const RawEvent& event);
  /// The port of a link disappears, or comes back and can be opened again.
  void set_port(std::size_t link, bool there);
  /// What fed a link has nothing more: what waits in its drivers comes out, and their silence is no
  /// fault.
  void end_of_recording(std::size_t link);
  /// Lets timers expire until `end`, then stops the devices.
  void finish(Stamp end);

  Stamp now() const { return clock_.now(); }
  const std::vector<std::unique_ptr<shell::DeviceActor>>& devices() const { return devices_; }

 private:
  explicit Player(Stamp start) : clock_(start) {}

  shell::Lockstep clock_;
  std::vector<std::unique_ptr<device::Transmitter>> transmitters_;  ///< by device
  std::vector<std::unique_ptr<shell::DeviceActor>> devices_;
  std::vector<std::vector<shell::DeviceActor*>> on_link_;  ///< by link of the recording
};

/// Plays the selected part of a recording to its end. `on_event` is called before the devices
/// receive an event.
void play(Recording& recording, const Selection& selection, Player& player,
          const std::function<void(const RawEvent&)>& on_event = {});

/// Does the same for a file.
boost::system::result<void, RecordingError> play(const std::string& path,
                                                 const Selection& selection,
                                                 device::Listener& listener);

}  // namespace drydock::record
