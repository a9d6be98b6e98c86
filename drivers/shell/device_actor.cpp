#include "drivers/shell/device_actor.hpp"

#include <utility>

namespace drydock::shell {

DeviceActor::DeviceActor(std::unique_ptr<device::Device> device, device::Listener& listener,
                         device::Transmitter& transmitter, Stamp start,
                         measurement::Provenance provenance)
    : device_(std::move(device)), start_(start), provenance_(provenance) {
  device_->connect(listener, transmitter);
}

std::optional<Stamp> DeviceActor::deadline() const { return start_ ? start_ : device_->deadline(); }

void DeviceActor::act(Stamp now) {
  if (start_) {
    start_.reset();
    device_->start(now);
  }
  device_->tick(now);
  if (device_->wants_close()) device_->link_lost(now, "closed");
  if (!device_->wants_open()) return;
  if (port_is_there_)
    device_->opened(now, provenance_);
  else
    device_->open_failed(now, "there is no such port");
}

void DeviceActor::set_port(bool there, Stamp at) {
  port_is_there_ = there;
  if (!there) device_->link_lost(at, "the port is gone");
  woken();
}

}  // namespace drydock::shell
