#pragma once

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// A sampling device that is a CANopen node (CiA 301): boot-up message, heartbeat each second
/// (1017h changes it), obedience to NMT, expedited SDO server, emergencies. Operational, it samples
/// at its rate or, where the configuration says so, on each SYNC.
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

  /// Node 1 unless the configuration names another. `device_type`: object 1000h.
  CanopenDevice(const DeviceSetup& setup, std::uint32_t device_type);

  /// Sends the process data of the truth at `at`; called only while the node is operational.
  virtual void report(Stamp at, Wire& out) = 0;

  /// What stands in an entry of the profile or the maker; 1000h, 1001h, 1017h, 1018h and what
  /// follows from pdos() are known here.
  virtual std::optional<Object> object(const wire::canopen::ObjectEntry&) const { return {}; }

  /// What each transmit PDO holds, as 1A00h writes it: index << 16 | subindex << 8 | bits.
  using Mapping = std::span<const std::uint32_t>;
  virtual std::span<const Mapping> pdos() const { return {}; }

  /// Sends an emergency where the fault is another than before; code 0 says that it is gone.
  void set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out);

  std::uint8_t node() const { return node_; }

 private:
  void sample(Stamp at, Wire& out) final;
  void beat(Stamp now, Wire& out);
  void obey(const wire::canopen::Nmt& order, Stamp now, Wire& out);
  std::optional<Object> find(const wire::canopen::ObjectEntry& entry) const;
  std::optional<Object> pdo_object(const wire::canopen::ObjectEntry& entry) const;
  void serve(const wire::canopen::SdoRead& request, Wire& out) const;
  void serve(const wire::canopen::SdoWrite& request, Stamp now, Wire& out);

  std::uint8_t node_;
  std::uint32_t device_type_;
  bool on_sync_;
  wire::canopen::NodeState state_ = wire::canopen::NodeState::boot_up;
  std::chrono::milliseconds heartbeat_period_{1000};  ///< zero: none
  std::optional<Stamp> next_heartbeat_;
  std::optional<Stamp> synced_;  ///< a sample taken on SYNC that has not left yet
  std::uint16_t fault_ = 0;
  std::uint8_t error_register_ = 0;
};

}  // namespace drydock::emulate
