#include "drivers/device/dvl/water_linked_settings.hpp"

#include <cmath>
#include <numbers>

#include "drivers/device/fixed_text.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::device {

namespace {

namespace water_linked = wire::water_linked;

/// The serial protocol sends parameters with two decimals.
constexpr double same_sound_speed_mps = 0.01, same_rotation_rad = 0.01 * units::degree;

Reason with_number(std::string_view before, double value, std::string_view behind) {
  std::array<std::uint8_t, 32> digits;
  wire::FieldWriter number{digits};
  number.number(value, 2);
  Reason text{before};
  text += wire::as_text(number.written());
  text += behind;
  return text;
}

bool sound_speed_agrees(const std::optional<double>& wanted, const std::optional<double>& read,
                        Output& out) {
  if (!wanted || !read || std::abs(*read - *wanted) <= same_sound_speed_mps) return true;
  out.report(
      with_number("the DVL uses a speed of sound of ", *read, " m/s, not the one of the rig file")
          .view());
  return false;
}

bool rotation_agrees(double wanted, const std::optional<double>& read, Output& out) {
  if (!read) return true;
  if (std::abs(std::remainder(*read - wanted, 2 * std::numbers::pi)) <= same_rotation_rad)
    return true;
  out.report(with_number("the DVL turns its velocities by ", wire::degrees(*read),
                         " degrees, not by the mounting_rotation_deg of the rig file")
                 .view());
  return false;
}

bool acoustics_agree(const std::optional<bool>& wanted, const std::optional<bool>& read,
                     Output& out) {
  if (wanted.value_or(true) && !read.value_or(true))
    out.report("the DVL's acoustics are switched off");
  return !wanted || !read || *wanted == *read;
}

bool range_mode_agrees(const WaterLinkedSettings& wanted, const water_linked::Configuration& read,
                       Output& out) {
  if (wanted.range_mode.empty() || read.range_mode.empty() || wanted.range_mode == read.range_mode)
    return true;
  out.report("the DVL has another range mode than the rig file says");
  return false;
}

}  // namespace

water_linked::Configuration to_set(const WaterLinkedSettings& wanted) {
  water_linked::Configuration settings;
  settings.sound_speed_mps = wanted.sound_speed_mps;
  settings.mounting_rotation_rad = wanted.mounting_rotation_rad;
  settings.acoustic_enabled = wanted.acoustic_enabled;
  settings.range_mode = wanted.range_mode;
  settings.periodic_cycling = wanted.periodic_cycling;
  return settings;
}

bool nothing_to_set(const WaterLinkedSettings& wanted) {
  return !wanted.sound_speed_mps && !wanted.mounting_rotation_rad && !wanted.acoustic_enabled &&
         wanted.range_mode.empty() && !wanted.periodic_cycling;
}

WaterLinkedAgreement compare(const WaterLinkedSettings& wanted,
                             const water_linked::Configuration& read, Output& out) {
  const bool sound = sound_speed_agrees(wanted.sound_speed_mps, read.sound_speed_mps, out);
  const bool rotation =
      rotation_agrees(wanted.mounting_rotation_rad.value_or(0), read.mounting_rotation_rad, out);
  const bool acoustics = acoustics_agree(wanted.acoustic_enabled, read.acoustic_enabled, out);
  const bool range_mode = range_mode_agrees(wanted, read, out);
  const bool turned = wanted.mounting_rotation_rad && !rotation;
  return {.velocities = sound && rotation, .settings = sound && !turned && acoustics && range_mode};
}

Reason keeps_other_values(std::string_view command) {
  Reason text{"the DVL refuses "};
  text += command;
  text += ": it says that it took it, and keeps other values";
  return text;
}

}  // namespace drydock::device
