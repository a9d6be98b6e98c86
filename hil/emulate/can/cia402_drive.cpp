#include <cstdlib>

#include "drivers/wire/canopen/cia402.hpp"

#include "hil/emulate/can/canopen_device.hpp"
#include "hil/emulate/can/ordered_actuator.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

namespace cia402 = wire::cia402;
namespace canopen = wire::canopen;
using cia402::DriveState;
using cia402::Mode;

constexpr std::uint32_t servo_drive = 0x00020192;  // device type: CiA 402, servo drive
constexpr std::uint16_t heartbeat_lost = 0x8130;   // emergency code of CiA 301
constexpr std::uint8_t communication_error = 0x11;
constexpr std::uint32_t wrong_length = 0x06070010, beyond_range = 0x06090030;

constexpr std::array<std::uint32_t, 2> position_sent{0x60410010, 0x60640020},
    velocity_sent{0x60410010, 0x606C0020}, position_taken{0x60400010, 0x607A0020},
    velocity_taken{0x60400010, 0x60FF0020};
using Mappings = std::array<std::span<const std::uint32_t>, 1>;
constexpr Mappings sent_by_position{position_sent}, sent_by_velocity{velocity_sent},
    taken_by_position{position_taken}, taken_by_velocity{velocity_taken};

/// Moves the actuator whose number is the configured instance. Surfaces are positioned; a propeller
/// and a thruster have a velocity.
class Cia402Drive final : public CanopenDevice {
 public:
  explicit Cia402Drive(const DeviceSetup& setup)
      : CanopenDevice(setup, servo_drive),
        number_(setup.config.instance.value_or(0)),
        angle_errors_(setup.primary_errors()),
        shaft_errors_(setup.secondary_errors()),
        actuator_(setup, number_),
        mode_(turns() ? Mode::profile_velocity : Mode::cyclic_position) {}

 private:
  void report(Stamp at, Wire& out) override {
    actual_ = cia402::increments_of(with_errors(trajectory().at(at), at));
    out.send(encode(cia402::DriveStatus{node(), status_word(), actual_}));
  }

  /// With the bits of the mode, CiA 402-2.
  std::uint16_t status_word() const {
    constexpr std::int32_t window = cia402::increments_per_turn / 100;  // a second
    std::uint16_t word = cia402::status_word_of(state_);
    if (state_ != DriveState::operation_enabled || shown_mode_ != mode_) return word;
    if (limited_) word |= cia402::internal_limit_active;
    if (!turns()) return word | cia402::follows_target;
    const std::int64_t off = std::int64_t{target_} - actual_;
    if (std::abs(off) <= window) word |= cia402::target_reached;
    if (std::abs(actual_) <= window) word |= cia402::speed_is_zero;
    return word;
  }

  double with_errors(const motion::Truth& truth, Stamp at) {
    if (turns()) return shaft_errors_.apply(sensor::ideal_shaft(truth, number_), at);
    const auto ideal = sensor::ideal_actuators(truth);
    return angle_errors_.apply({*ideal.rudder_rad, *ideal.stern_plane_rad, *ideal.bow_plane_rad},
                               at)[number_];
  }

  void hear(const wire::CanFrame& frame, Stamp now, Wire& out) override {
    if (const auto beat = canopen::decode_heartbeat(frame)) {
      if (beat->node == watched_ >> 16) master_heard_at_ = now;
    } else if (const auto order = cia402::decode_order(frame)) {
      if (!is_operational() || order->node != node() || !takes_pdo(0)) return;
      target_ = order->target;
      take(order->control_word, now, out);
    }
  }

  void take(std::uint16_t word, Stamp now, Wire& out) {
    const DriveState before = state_;
    state_ = cia402::after(state_, word, word_);
    word_ = word;
    if (before == DriveState::fault && state_ != before) set_fault(0, 0, out);
    if (state_ == DriveState::operation_enabled && shown_mode_ == mode_) {
      limited_ = !actuator_.order(target_ * cia402::radians_per_increment, now);
    } else if (before == DriveState::operation_enabled && state_ != before) {
      actuator_.stop(now);
    }
  }

  /// CiA 301 watches a node from its first heartbeat on.
  void watch(Stamp at, Wire& out) override {
    const std::chrono::milliseconds patience{watched_ & 0xFFFF};
    if (patience.count() == 0 || !master_heard_at_ || at - *master_heard_at_ <= patience) return;
    master_heard_at_.reset();
    if (state_ == DriveState::operation_enabled) actuator_.stop(at);
    state_ = DriveState::fault;
    set_fault(heartbeat_lost, communication_error, out);
  }

  void reset_communication() override {
    watched_ = 0;
    master_heard_at_.reset();
  }

  void reset_application(Stamp now) override {
    if (state_ == DriveState::operation_enabled) actuator_.stop(now);
    state_ = DriveState::switch_on_disabled;
    shown_mode_.reset();
    word_ = 0;
    target_ = 0;
  }

  std::optional<std::uint32_t> set(const canopen::SdoWrite& request, Stamp now,
                                   Wire& out) override {
    const auto takes = [&](std::uint8_t size) { return request.size == size ? 0 : wrong_length; };
    const auto [index, subindex] = request.entry;
    if (index == cia402::consumer_heartbeat_index && subindex == 1) {
      if (takes(4) == 0) watched_ = request.value;
      return takes(4);
    }
    if (subindex != 0) return {};
    if (index == cia402::control_word_index) {
      if (takes(2) == 0) take(static_cast<std::uint16_t>(request.value), now, out);
      return takes(2);
    }
    if (index == (turns() ? cia402::target_velocity_index : cia402::target_position_index)) {
      if (takes(4) == 0) {
        target_ = static_cast<std::int32_t>(request.value);
        take(word_, now, out);
      }
      return takes(4);
    }
    if (index != cia402::mode_index) return {};
    if (takes(1) != 0) return takes(1);
    if (request.value != static_cast<std::uint32_t>(mode_)) return beyond_range;
    shown_mode_ = mode_;
    return 0;
  }

  std::optional<Object> object(const canopen::ObjectEntry& entry) const override {
    if (entry.subindex != 0) return element(entry);
    const auto mode = shown_mode_ ? static_cast<std::uint32_t>(*shown_mode_) : 0U;
    switch (entry.index) {
      case cia402::consumer_heartbeat_index: return Object{1, 1};
      case cia402::control_word_index: return Object{word_, 2};
      case cia402::status_word_index: return Object{status_word(), 2};
      case cia402::mode_index:
      case cia402::mode_shown_index: return Object{mode, 1};
      case cia402::encoder_index: return Object{2, 1};
      case cia402::supported_modes_index:
        return Object{1U << (static_cast<unsigned>(mode_) - 1), 4};
      default: break;
    }
    if (entry.index == (turns() ? cia402::velocity_index : cia402::position_index))
      return Object{static_cast<std::uint32_t>(actual_), 4};
    if (entry.index == (turns() ? cia402::target_velocity_index : cia402::target_position_index))
      return Object{static_cast<std::uint32_t>(target_), 4};
    return element(entry);
  }

  /// The arrays.
  std::optional<Object> element(const canopen::ObjectEntry& entry) const {
    const auto of = [&](auto... values) -> std::optional<Object> {
      const std::array<Object, sizeof...(values)> all{values...};
      if (entry.subindex >= all.size()) return {};
      return all.at(entry.subindex);
    };
    switch (entry.index) {
      case cia402::consumer_heartbeat_index: return of(Object{1, 1}, Object{watched_, 4});
      case cia402::encoder_index:
        return of(Object{2, 1}, Object{cia402::increments_per_turn, 4}, Object{1, 4});
      default: return {};
    }
  }

  std::span<const Mapping> pdos() const override {
    return turns() ? sent_by_velocity : sent_by_position;
  }
  std::span<const Mapping> taken_pdos() const override {
    return turns() ? taken_by_velocity : taken_by_position;
  }

  bool turns() const { return actuator_.turns(); }

  int number_;
  sensor::ErrorModel angle_errors_, shaft_errors_;
  OrderedActuator actuator_;
  Mode mode_;                       ///< the only one that it has
  std::optional<Mode> shown_mode_;  ///< empty: nobody has set it yet
  DriveState state_ = DriveState::switch_on_disabled;
  std::uint16_t word_ = 0;
  std::int32_t target_ = 0, actual_ = 0;
  bool limited_ = false;       ///< the target is beyond what the actuator can do
  std::uint32_t watched_ = 0;  ///< object 1016h, 1: a node << 16 and its longest silence in ms
  std::optional<Stamp> master_heard_at_;
};

}  // namespace

DevicePtr make_cia402_drive(const DeviceSetup& setup) {
  return std::make_unique<Cia402Drive>(setup);
}

}  // namespace drydock::emulate
