#pragma once

#include "drivers/wire/canopen/canopen.hpp"
#include "hil/emulate/can/canopen_codes.hpp"
#include "hil/emulate/can/canopen_errors.hpp"
#include "hil/emulate/can/canopen_life.hpp"
#include "hil/emulate/can/canopen_schedule.hpp"
#include "hil/emulate/can/canopen_sdo_server.hpp"
#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// What kind of node a device is, as delivered. The spans and the name outlive it.
struct CanopenProfile {
  std::uint32_t device_type = 0;             ///< object 1000h
  std::string_view name;                     ///< object 1008h
  std::span<const PdoMapping> sends, takes;  ///< its PDOs
  /// What a master may map into them, in the form of a mapping.
  std::span<const std::uint32_t> sendable, takeable;
  std::uint8_t when_lost = CanopenSettings::to_pre_operational;  ///< object 1029h
};

/// A sampling device that is a CANopen node (CiA 301): boot-up message, heartbeat each second, NMT,
/// SDO server, emergencies, node guarding, a watch on its master. In the operational state it
/// samples at its rate, or on each SYNC if the configuration says so; a master may set up its PDOs
/// and its communication until a reset, or save them (1010h). How it was set up it says to the
/// bench.
class CanopenDevice : public SamplingDevice, private CanopenDictionary {
 public:
  std::optional<Stamp> deadline() const final;
  void tick(Stamp now, Wire& out) final;
  using SamplingDevice::receive;
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) final;

 protected:
  using Object = CanopenObject;
  using Entry = wire::canopen::ObjectEntry;

  /// The node number is 1 unless the configuration gives another.
  CanopenDevice(const DeviceSetup& setup, const CanopenProfile& profile);

  /// Measures the truth at `at`: object() tells it from then on, and PDOs send it. Called only in
  /// the operational state.
  virtual void measure(Stamp at, Wire& out) = 0;

  /// An object of the profile or the manufacturer, from 2000h on.
  virtual std::optional<Object> object(const Entry&) const { return {}; }

  /// Whether a master can set an object of the profile.
  virtual bool takes(const Entry&) const { return false; }
  /// Sets one that it takes; returns the code of the refusal, 0 for none. act() follows each
  /// message that has set some.
  virtual std::uint32_t put(const Entry&, std::uint32_t /*value*/) { return 0; }
  virtual void act(Stamp /*now*/, Wire&) {}

  virtual void reset_application(Stamp /*now*/) {}  ///< its objects get their power-on values
  virtual void lose_master(Stamp, Wire&) {}
  virtual void find_master(Wire& out) { set_fault(0, 0, out); }

  /// Sends an emergency if the fault has changed. Code 0 means that the fault is over.
  void set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out);

  std::uint8_t node() const { return node_; }
  bool is_operational() const { return state_ == wire::canopen::NodeState::operational; }

 private:
  void sample(Stamp at, Wire& out) final;
  void beat(Stamp now, Wire& out);
  void obey(const wire::canopen::Nmt& order, Stamp now, Wire& out);
  void enter(wire::canopen::NodeState state, Stamp now);
  void power_on(bool application, Stamp now, Wire& out);
  void recall();
  void keep();

  void answer_guarding(Stamp now, Wire& out);
  void hear_sync(Stamp now, Wire& out);
  void hear_pdo(const wire::CanFrame& frame, Stamp now, Wire& out);
  void take_pdo(const CanopenPdo& pdo, const wire::CanFrame& frame, Stamp now, Wire& out);
  wire::CanFrame filled(const CanopenPdo& pdo) const;
  void mind_master(Stamp now, Wire& out);

  std::optional<Object> find(const Entry& entry) const;
  std::optional<Object> find_general(const Entry& entry) const;
  std::uint32_t missing(const Entry& entry) const;
  Found read_entry(const Entry& entry) const final;
  std::uint32_t write_entry(const wire::canopen::SdoWrite& request, Stamp now, Wire& out) final;
  std::optional<std::uint32_t> set(const wire::canopen::SdoWrite& request, Stamp now, Wire& out);
  std::optional<std::uint32_t> set_pdo(const wire::canopen::SdoWrite& request, Stamp now,
                                       Wire& out);
  std::optional<std::uint32_t> set_general(const wire::canopen::SdoWrite& request, Wire& out);

  CanopenProfile profile_;
  std::uint8_t node_;
  std::uint32_t serial_number_;
  std::shared_ptr<Memory> memory_;
  CanopenPdos tpdos_, rpdos_;
  CanopenSettings settings_;
  CanopenSchedule schedule_;
  CanopenSchedule::Chosen chosen_{};  ///< PDOs that go with the present sample
  CanopenSdoServer sdo_;
  CanopenLife life_;
  CanopenErrors errors_;
  wire::canopen::NodeState state_ = wire::canopen::NodeState::boot_up;
  std::optional<Stamp> next_heartbeat_;
  std::optional<Stamp> synced_;  ///< a sample taken on SYNC that is not sent yet
  std::array<std::optional<wire::CanFrame>, CanopenPdos::most> waiting_;  ///< for SYNC
  std::uint16_t fault_ = 0;
  std::uint8_t error_register_ = 0;
};

}  // namespace drydock::emulate
