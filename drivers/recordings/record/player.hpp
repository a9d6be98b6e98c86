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

/// What the attached rig file says of the drivers. Mission and sensor files are not needed.
boost::system::result<rig_config::Rig, RecordingError> rig_of(const Recording& recording);

/// The drivers of a recorded rig in the lockstep shell, fed with the bytes and frames that they
/// once received: the same measurements again, at the same times, to the last bit. What they send
/// reaches nobody; what was answered then is in the recording.
class Player final {
 public:
  /// Drivers of the selected devices on links of the recording. What they send is told to `sent`,
  /// where given. Both must outlive the player.
  static boost::system::result<std::unique_ptr<Player>, RecordingError> make(
      const Recording& recording, const rig_config::Rig& rig, const Selection& selection,
      device::Listener& listener, shell::RawListener* sent = nullptr);

  /// A host's clock that was set leaves decades without a message. Past this pause every driver has
  /// given up what it waited for, and the rest of it is skipped.
  static constexpr std::chrono::hours longest_pause{1};

  /// Time goes on, and drivers that waited for it act.
  void run_until(Stamp at);
  /// Time goes on to the event's, then its devices hear it. Sent bytes only let time go on.
  void play(const RawEvent& event);
  /// The port of a link goes, or comes back and can be opened again.
  void set_port(std::size_t link, bool there);
  /// Lets timers run out until `end`, then stops the devices.
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

/// Plays the selected part of a recording to its end. `on_event` is told first.
void play(Recording& recording, const Selection& selection, Player& player,
          const std::function<void(const RawEvent&)>& on_event = {});

/// The same of a file.
boost::system::result<void, RecordingError> play(const std::string& path,
                                                 const Selection& selection,
                                                 device::Listener& listener);

}  // namespace drydock::record
