#pragma once

#include <memory>

#include "drivers/device/device.hpp"
#include "drivers/shell/lockstep.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::shell {

/// A device in the lockstep shell. Its link is a line in the same process: it opens at once, and
/// its provenance is that of the line's other end. The emulated line calls receive() when the bytes
/// have arrived.
class DeviceActor final : public Actor {
 public:
  /// Opens the device at the first act(), at `start`. Listener and transmitter must outlive it.
  DeviceActor(std::unique_ptr<device::Device> device, device::Listener& listener,
              device::Transmitter& transmitter, Stamp start,
              measurement::Provenance provenance = measurement::Provenance::emulated);

  /// `raw` sees all traffic of its link; of the devices on one link only one is tapped. `raw` must
  /// outlive the actor.
  void tap(RawListener& raw) { raw_ = &raw; }

  void receive(wire::Bytes bytes, Stamp at) {
    if (raw_ != nullptr) raw_->on_bytes(device_->options().link, Direction::received, bytes, at);
    device_->receive(bytes, at);
    woken();
  }
  void receive(const wire::CanFrame& frame, Stamp at) {
    if (raw_ != nullptr) raw_->on_frame(device_->options().link, Direction::received, frame, at);
    device_->receive(frame, at);
    woken();
  }

  /// The port behind the link disappears, or comes back and can be opened again.
  void set_port(bool there, Stamp at);

  std::optional<Stamp> deadline() const override;
  void act(Stamp now) override;

  void share_link() { device_->share_link(); }
  /// The recording behind the link has nothing more.
  void end_of_recording(Stamp now) {
    device_->end_of_recording(now);
    woken();
  }
  void stop(Stamp now) {
    device_->stop(now);
    woken();
  }
  const device::Device& device() const { return *device_; }

 private:
  std::unique_ptr<device::Device> device_;
  std::optional<Stamp> start_;  ///< empty once started
  measurement::Provenance provenance_;
  RawListener* raw_ = nullptr;
  bool port_is_there_ = true;
};

}  // namespace drydock::shell
