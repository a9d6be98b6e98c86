#pragma once

#include <string>
#include <vector>

#include "drivers/capture/capture_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/recording_clock.hpp"

namespace drydock::shell {

/// A capture of a CAN bus (`file:` link) in the lockstep shell. Its frames reach the drivers at the
/// capture's own times, counted from `start`. In a capture without times they come when the
/// device's clock says. Without such a clock they follow each other as on a bus of the link's
/// `bitrate` that is never idle. At the end of the file the bus falls silent, which is no fault of
/// the devices.
class RecordedBus final : public Actor {
 public:
  /// Throws std::runtime_error with one line if the file cannot be read or is no capture.
  RecordedBus(const link::Uri& uri, std::vector<DeviceActor*> drivers, Stamp start,
              RecordingClock clock);

  std::optional<Stamp> deadline() const override;
  void act(Stamp now) override;
  const capture::FrameCapture& frames() const { return file_.frames(); }
  /// What a person must know of its times as far as the file was read.
  std::vector<std::string> notes() const;
  const RecordingClock& clock() const { return clock_; }

 private:
  void read_next();
  Stamp due_of(const capture::Record& record);

  capture::CaptureFile file_;
  std::vector<DeviceActor*> drivers_;
  std::optional<wire::CanFrame> frame_;  ///< the next frame; empty at the end
  RecordingClock clock_;
  std::chrono::nanoseconds frame_on_a_full_bus_;
  std::size_t message_ = 0;   ///< the next of the device's clock
  std::uint64_t frames_ = 0;  ///< read
  Stamp start_, due_;
};

}  // namespace drydock::shell
