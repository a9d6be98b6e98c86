#pragma once

#include <memory>
#include <string>

#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// A device that boots after it gets power. Until then it ignores all input. Then it sends its
/// banner, and after that the output of the inner device.
class BootingDevice final : public EmulatedDevice {
 public:
  BootingDevice(std::unique_ptr<EmulatedDevice> device, Stamp booted, std::string banner)
      : device_(std::move(device)), booted_(booted), banner_(std::move(banner)) {}

  std::optional<Stamp> deadline() const override {
    return has_booted_ ? device_->deadline() : std::optional(booted_);
  }
  std::optional<Stamp> sampled_at() const override { return device_->sampled_at(); }
  void tick(Stamp now, Wire& out) override;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    if (has_booted_) device_->receive(bytes, now, out);
  }
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) override {
    if (has_booted_) device_->receive(frame, now, out);
  }

 private:
  std::unique_ptr<EmulatedDevice> device_;
  Stamp booted_;
  std::string banner_;
  bool has_booted_ = false;
};

inline void BootingDevice::tick(Stamp now, Wire& out) {
  if (!has_booted_ && now >= booted_) {
    has_booted_ = true;
    const auto* text = reinterpret_cast<const std::uint8_t*>(banner_.data());
    if (!banner_.empty()) out.send(wire::Bytes{text, banner_.size()});
  }
  if (device_->deadline() && *device_->deadline() <= now) device_->tick(now, out);
}

}  // namespace drydock::emulate
