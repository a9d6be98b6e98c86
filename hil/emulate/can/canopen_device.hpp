#pragma once

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "hil/emulate/can/canopen_pdos.hpp"
#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// A sampling device that is a CANopen node (CiA 301): boot-up message, heartbeat each second
/// (1017h changes it until a reset), NMT, expedited SDO server, emergencies. In the operational
/// state it samples at its rate, or on each SYNC if the configuration says so; a master may change
/// that and switch PDOs off until a reset.
class CanopenDevice : public SamplingDevice {
 public:
  std::optional<Stamp> deadline() const final;
  void tick(Stamp now, Wire& out) final;
  using SamplingDevice::receive;
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) final;

 protected:
  struct Object {
    std::uint32_t value = 0;
    std::uint8_t size = 4;
  };

  /// The node number is 1 unless the configuration gives another. `device_type`: object 1000h.
  CanopenDevice(const DeviceSetup& setup, std::uint32_t device_type);

  /// Sends the process data of the truth at `at`. Called only in the operational state.
  virtual void report(Stamp at, Wire& out) = 0;

  /// An object of the profile or the manufacturer. This class handles 1000h, 1001h, 1017h, 1018h
  /// and the objects that follow from pdos().
  virtual std::optional<Object> object(const wire::canopen::ObjectEntry&) const { return {}; }

  /// Receives a frame that is none of CiA 301's services for this node. Not while it is stopped.
  virtual void hear(const wire::CanFrame&, Stamp /*now*/, Wire&) {}

  /// Called at each sample, in every state.
  virtual void watch(Stamp /*at*/, Wire&) {}

  /// Sets an object of the profile. Empty: there is no such object, or none that can be set; else
  /// the code of the refusal, 0 for none.
  virtual std::optional<std::uint32_t> set(const wire::canopen::SdoWrite&, Stamp /*now*/, Wire&) {
    return {};
  }

  /// NMT resets: what was set gets its power-on value. This class does so for 1017h. A reset of the
  /// node also resets the communication.
  virtual void reset_communication() {}
  virtual void reset_application(Stamp /*now*/) {}

  using Mapping = PdoMapping;
  virtual std::span<const Mapping> pdos() const { return {}; }        ///< that it sends
  virtual std::span<const Mapping> taken_pdos() const { return {}; }  ///< that it receives
  bool takes_pdo(std::size_t pdo) const { return rpdos_[pdo].is_on(); }

  /// Sends an emergency if the fault has changed. Code 0 means that the fault is over.
  void set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out);

  std::uint8_t node() const { return node_; }
  bool is_operational() const { return state_ == wire::canopen::NodeState::operational; }

 private:
  void sample(Stamp at, Wire& out) final;
  void beat(Stamp now, Wire& out);
  void obey(const wire::canopen::Nmt& order, Stamp now, Wire& out);
  std::optional<Object> find(const wire::canopen::ObjectEntry& entry) const;
  std::uint32_t missing(const wire::canopen::ObjectEntry& entry) const;
  std::optional<std::uint32_t> set_pdo(const wire::canopen::SdoWrite& request, Stamp now);
  bool samples_on_sync() const { return tpdos_.any_synchronous(pdos().size()); }
  bool samples_by_time() const { return tpdos_.any_by_time(pdos().size()); }
  void reset_pdos();
  void power_on(bool application, Stamp now, Wire& out);
  void serve(const wire::canopen::SdoRead& request, Wire& out) const;
  void serve(const wire::canopen::SdoWrite& request, Stamp now, Wire& out);
  std::optional<std::uint32_t> refusal_of(const wire::canopen::SdoWrite& request, Stamp now,
                                          Wire& out);

  std::uint8_t node_;
  std::uint32_t device_type_;
  bool on_sync_;  ///< as the rig has it
  CanopenPdos tpdos_, rpdos_;
  bool by_sync_ = false;  ///< the present sample was asked for by SYNC
  wire::canopen::NodeState state_ = wire::canopen::NodeState::boot_up;
  static constexpr std::chrono::milliseconds power_on_heartbeat{1000};
  std::chrono::milliseconds heartbeat_period_ = power_on_heartbeat;  ///< zero: none
  std::optional<Stamp> next_heartbeat_;
  std::optional<Stamp> synced_;  ///< a sample taken on SYNC that is not sent yet
  std::uint16_t fault_ = 0;
  std::uint8_t error_register_ = 0;
};

}  // namespace drydock::emulate
