#include <cstdlib>

#include "drivers/wire/canopen/cia402.hpp"

#include "hil/emulate/can/canopen_device.hpp"
#include "hil/emulate/can/ordered_actuator.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

namespace cia402 = wire::cia402;
using cia402::DriveState;
using cia402::Mode;

constexpr std::uint32_t servo_drive = 0x00020192;  // device type: CiA 402, servo drive

constexpr std::array<std::uint32_t, 2> position_sent{0x60410010, 0x60640020},
    velocity_sent{0x60410010, 0x606C0020}, position_taken{0x60400010, 0x607A0020},
    velocity_taken{0x60400010, 0x60FF0020};
using Mappings = std::array<PdoMapping, 1>;
constexpr Mappings sent_by_position{position_sent}, sent_by_velocity{velocity_sent},
    taken_by_position{position_taken}, taken_by_velocity{velocity_taken};
constexpr std::array<std::uint32_t, 3> position_sendable{0x60410010, 0x60610008, 0x60640020},
    velocity_sendable{0x60410010, 0x60610008, 0x606C0020},
    position_takeable{0x60400010, 0x60600008, 0x607A0020},
    velocity_takeable{0x60400010, 0x60600008, 0x60FF0020};

/// A drive that has lost its master stops by its fault, and stays operational (1029h).
CanopenProfile profile_of(const DeviceSetup& setup) {
  constexpr std::string_view name = "Drydock emulated drive";
  if (setup.config.instance.value_or(0) >= measurement::propeller_number)
    return {servo_drive,           name,
            sent_by_velocity,      taken_by_velocity,
            velocity_sendable,     velocity_takeable,
            CanopenSettings::stays};
  return {servo_drive,           name,
          sent_by_position,      taken_by_position,
          position_sendable,     position_takeable,
          CanopenSettings::stays};
}

/// Moves the actuator whose number is the configured instance. Surfaces are positioned; a propeller
/// and a thruster have a velocity.
class Cia402Drive final : public CanopenDevice {
 public:
  explicit Cia402Drive(const DeviceSetup& setup)
      : CanopenDevice(setup, profile_of(setup)),
        number_(setup.config.instance.value_or(0)),
        angle_errors_(setup.primary_errors()),
        shaft_errors_(setup.secondary_errors()),
        actuator_(setup, number_),
        mode_(turns() ? Mode::profile_velocity : Mode::cyclic_position) {}

 private:
  void measure(Stamp at, Wire&) override {
    actual_ = cia402::increments_of(with_errors(trajectory().at(at), at));
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

  void lose_master(Stamp at, Wire&) override {
    if (state_ == DriveState::operation_enabled) actuator_.stop(at);
    state_ = DriveState::fault;
  }
  void find_master(Wire&) override {}  // the fault stays until its reset

  void reset_application(Stamp now) override {
    if (state_ == DriveState::operation_enabled) actuator_.stop(now);
    state_ = DriveState::switch_on_disabled;
    shown_mode_.reset();
    word_ = ordered_word_ = 0;
    target_ = 0;
  }

  std::uint16_t target_index() const {
    return turns() ? cia402::target_velocity_index : cia402::target_position_index;
  }

  bool takes(const Entry& entry) const override {
    return entry.subindex == 0 &&
           (entry.index == cia402::control_word_index || entry.index == cia402::mode_index ||
            entry.index == target_index());
  }

  std::uint32_t put(const Entry& entry, std::uint32_t value) override {
    if (entry.index == cia402::control_word_index) {
      ordered_word_ = static_cast<std::uint16_t>(value);
    } else if (entry.index == target_index()) {
      target_ = static_cast<std::int32_t>(value);
    } else if (value == static_cast<std::uint32_t>(mode_)) {
      shown_mode_ = mode_;
    } else {
      return sdo::beyond_range;
    }
    return sdo::taken;
  }

  void act(Stamp now, Wire& out) override { take(ordered_word_, now, out); }

  std::optional<Object> object(const Entry& entry) const override {
    if (entry.subindex != 0) return element(entry);
    const auto mode = shown_mode_ ? static_cast<std::uint32_t>(*shown_mode_) : 0U;
    switch (entry.index) {
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
    if (entry.index == target_index()) return Object{static_cast<std::uint32_t>(target_), 4};
    return element(entry);
  }

  /// The arrays.
  std::optional<Object> element(const Entry& entry) const {
    const auto of = [&](auto... values) -> std::optional<Object> {
      const std::array<Object, sizeof...(values)> all{values...};
      if (entry.subindex >= all.size()) return {};
      return all.at(entry.subindex);
    };
    switch (entry.index) {
      case cia402::encoder_index:
        return of(Object{2, 1}, Object{cia402::increments_per_turn, 4}, Object{1, 4});
      default: return {};
    }
  }

  bool turns() const { return actuator_.turns(); }

  int number_;
  sensor::ErrorModel angle_errors_, shaft_errors_;
  OrderedActuator actuator_;
  Mode mode_;                       ///< the only one that it has
  std::optional<Mode> shown_mode_;  ///< empty: nobody has set it yet
  DriveState state_ = DriveState::switch_on_disabled;
  std::uint16_t word_ = 0, ordered_word_ = 0;
  std::int32_t target_ = 0, actual_ = 0;
  bool limited_ = false;  ///< the target is beyond what the actuator can do
};

}  // namespace

DevicePtr make_cia402_drive(const DeviceSetup& setup) {
  return std::make_unique<Cia402Drive>(setup);
}

}  // namespace drydock::emulate
