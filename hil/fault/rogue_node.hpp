#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "hil/fault/schedule/schedule_follower.hpp"
#include "hil/sensor/random.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Class of its error frames while it is not bus-off: linux/can/error.h.
inline constexpr std::uint32_t protocol_violation = 0x008;

/// Other disturbances on a CAN bus: one more node that babbles, loads the bus or takes a device's
/// address, and the drivers' controller that sees errors or goes bus-off. Silent without a fault.
class RogueNode final : public emulate::EmulatedDevice {
 public:
  /// Acts on the faults of one device on the bus.
  RogueNode(const rig_config::DeviceConfig& config, unsigned bit_rate, std::uint64_t seed,
            Stamp start, std::shared_ptr<const Schedule> schedule);

  std::optional<Stamp> deadline() const override;
  void tick(Stamp now, emulate::Wire& out) override;
  void receive(wire::Bytes, Stamp, emulate::Wire&) override {}
  void receive(const wire::CanFrame& frame, Stamp now, emulate::Wire& out) override;

 private:
  /// An action that repeats while a fault is in force.
  struct Beat {
    FaultKind kind;
    std::chrono::nanoseconds period{0};  ///< zero: not in force
    Stamp next{};
  };

  void follow_schedule(Stamp now, emulate::Wire& out);
  void set_beat(Beat& beat, const InForce* fault, Stamp now);
  void go_bus_off(bool off, emulate::Wire& out);
  std::chrono::nanoseconds period_of(const FaultConfig& fault) const;
  void strike(const Beat& beat, emulate::Wire& out);
  void steal_address(bool wanted, Stamp now, emulate::Wire& out);
  void claim_address(Stamp now, emulate::Wire& out);
  void note_address(const wire::CanFrame& frame);

  unsigned bit_rate_;
  std::string protocol_;
  std::uint32_t identity_;               ///< in the device's NAME
  std::optional<std::uint8_t> address_;  ///< the device's; empty: not stated, and it claimed none
  bool steals_ = false;
  std::optional<wire::j1939::AddressClaim> claim_;  ///< set while this node holds the device's
                                                    ///< address
  sensor::RandomStream random_;
  ScheduleFollower schedule_;
  std::array<Beat, 3> beats_;
  bool bus_off_ = false;
};

}  // namespace drydock::fault
