#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "hil/emulate/make_emulated_device.hpp"
#include "hil/fault/port_faults.hpp"
#include "hil/fault/schedule/schedule_follower.hpp"
#include "hil/fault/wire/faulty_wire.hpp"
#include "hil/motion/ordered/takes_orders.hpp"

namespace drydock::fault {

using rig_config::DeviceConfig;

/// Any emulated device under the faults of a schedule. Faults act on its sensors and its clock, its
/// power, its port, and the wire of its messages. Without a fault it passes on every message at
/// once.
class FaultyDevice final : public emulate::EmulatedDevice, private emulate::Wire {
 public:
  /// The trajectory must outlive the device. Fails as make_emulated_device() does.
  static boost::system::result<std::unique_ptr<FaultyDevice>, emulate::EmulateError> make(
      const DeviceConfig& config, const motion::Trajectory& trajectory, std::uint64_t seed,
      std::shared_ptr<const Schedule> schedule);

  std::optional<Stamp> deadline() const override;
  std::optional<Stamp> sampled_at() const override { return sampled_at_; }
  void tick(Stamp now, emulate::Wire& out) override;
  void receive(wire::Bytes bytes, Stamp now, emulate::Wire& out) override;
  void receive(const wire::CanFrame& frame, Stamp now, emulate::Wire& out) override;

 private:
  /// The vehicle's motion as the device sees it. Under the fault "stuck" it stands still.
  class View final : public motion::Trajectory, public motion::TakesOrders {
   public:
    View(const motion::Trajectory& motion, std::shared_ptr<const emulate::Condition> condition)
        : motion_(motion), condition_(std::move(condition)) {}
    motion::Truth at(Stamp time) const override;
    Stamp start() const override { return motion_.start(); }
    Stamp end() const override { return motion_.end(); }
    const ocean::Ocean& ocean() const override { return motion_.ocean(); }
    motion::OrderSink* orders() const override { return motion::orders_of(motion_); }

   private:
    const motion::Trajectory& motion_;
    std::shared_ptr<const emulate::Condition> condition_;
    /// Since when it stands still, and where: a steered motion keeps only its last seconds.
    mutable std::optional<std::pair<Stamp, motion::Truth>> held_;
  };

  FaultyDevice(const DeviceConfig& config, const motion::Trajectory& trajectory, std::uint64_t seed,
               std::shared_ptr<const Schedule> schedule);

  void follow_schedule(Stamp now);
  void switch_power(bool on, Stamp now);
  void release(Stamp now);
  bool hears() const { return device_ && !port_.unplugged() && !bytes_.silent(); }

  void send(wire::Bytes bytes) override;
  void send(const wire::CanFrame& frame) override;
  /// While a fault is in force all clients hear it.
  void send_to(emulate::Client client, wire::Bytes bytes) override;
  emulate::Client speaker() const override { return out_->speaker(); }
  unsigned line_baud() const override { return out_->line_baud(); }
  void set_baud(unsigned baud) override { out_->set_baud(baud); }
  void tell(std::string_view what) override { out_->tell(what); }

  DeviceConfig config_;
  std::uint64_t seed_;
  ScheduleFollower schedule_;
  std::shared_ptr<emulate::Condition> condition_ = std::make_shared<emulate::Condition>();
  std::shared_ptr<emulate::Memory> memory_ = std::make_shared<emulate::Memory>();
  View view_;
  std::unique_ptr<emulate::EmulatedDevice> device_;  ///< null: without power
  FaultyWire<Message> bytes_;
  FaultyWire<wire::CanFrame> frames_;
  emulate::Wire* out_ = nullptr;  ///< valid during a call
  Stamp now_{};
  bool sound_ = true;                ///< no fault is in force
  std::optional<Stamp> sampled_at_;  ///< sample time of the current message
  PortFaults port_;
};

}  // namespace drydock::fault
