#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/shell/lockstep.hpp"
#include "hil/emulate/can_pacer.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "hil/emulate/line_pacer.hpp"

/// Emulated devices in the lockstep shell. Their messages arrive at the same times as on a real
/// line.
namespace drydock::emulate {

/// A device at the end of a serial line. If the device changes its baud rate, both ends read
/// garbage, because the drivers' end keeps its own.
class EmulatedLine final : public shell::Actor, private Wire {
 public:
  /// Gets each whole message when its last byte has left the line.
  using Deliver = std::function<void(wire::Bytes message, const Passage& passage)>;

  /// Called when the device's port goes (false) or comes back (true).
  using OnPort = std::function<void(bool there, Stamp at)>;

  EmulatedLine(std::unique_ptr<EmulatedDevice> device, wire::LineRate rate, Deliver deliver);

  void set_on_port(OnPort hook) { on_port_ = std::move(hook); }

  /// Called with what a host has told the device.
  using OnTold = std::function<void(std::string_view what, Stamp at)>;
  void set_on_told(OnTold hook) { on_told_ = std::move(hook); }

  void receive(wire::Bytes bytes, Stamp now);  ///< from the driver
  std::optional<Stamp> deadline() const override;
  void act(Stamp now) override;

  std::uint64_t messages_lost() const { return pacer_.messages_lost(); }

 private:
  void send(wire::Bytes bytes) override {
    pacer_.queue(bytes, now_, device_->sampled_at(), every_client, device_->sender());
  }
  void send(const wire::CanFrame&) override {}
  unsigned line_baud() const override {
    return hosts_rate_.baud == without_line_rate ? 0 : hosts_rate_.baud;
  }
  void set_baud(unsigned baud) override;
  void tell(std::string_view what) override { on_told_(what, now_); }
  void unplug() override { set_port(false); }
  void plug() override { set_port(true); }
  void set_port(bool there);

  std::unique_ptr<EmulatedDevice> device_;
  wire::LineRate hosts_rate_;  ///< the drivers' end keeps it
  LinePacer pacer_;
  Deliver deliver_;
  OnPort on_port_ = [](bool, Stamp) {};
  OnTold on_told_ = [](std::string_view, Stamp) {};
  Stamp now_{};
};

/// A CAN bus with its emulated nodes. Every frame reaches every other node. Frames of emulated
/// nodes also reach the drivers.
class EmulatedBus final : public shell::Actor {
 public:
  /// Gets each frame of an emulated node at the frame's end. `sender` is the index of the node in
  /// the order of add().
  using Deliver =
      std::function<void(const wire::CanFrame& frame, std::size_t sender, const Passage& passage)>;

  EmulatedBus(unsigned bit_rate, Deliver deliver);
  ~EmulatedBus() override;

  /// Called with what another node has told the node `sender`.
  using OnTold = std::function<void(std::size_t sender, std::string_view what, Stamp at)>;
  void set_on_told(OnTold hook) { on_told_ = std::move(hook); }

  void add(std::unique_ptr<EmulatedDevice> device);
  void receive(const wire::CanFrame& frame, Stamp now);  ///< from a driver
  void faults_changed();  ///< its devices may have to act at another time
  std::optional<Stamp> deadline() const override;
  void act(Stamp now) override;

  std::uint64_t frames_lost() const { return pacer_.frames_lost(); }

 private:
  struct Node;

  CanPacer pacer_;
  Deliver deliver_;
  OnTold on_told_ = [](std::size_t, std::string_view, Stamp) {};
  int cut_off_by_ = 0;  ///< number of nodes whose faults make the drivers' controller bus-off
  std::vector<std::unique_ptr<Node>> nodes_;
};

}  // namespace drydock::emulate
