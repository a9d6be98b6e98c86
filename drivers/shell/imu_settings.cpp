#include "drivers/shell/imu_settings.hpp"

#include <algorithm>
#include <array>

namespace drydock::shell {

namespace {

namespace aceinna = wire::aceinna;

constexpr int full_rate_hz = 100;
constexpr std::array cut_offs_hz{0, 2, 5, 10, 20, 25, 40, 50};

bool is_cut_off(int hz) { return std::ranges::find(cut_offs_hz, hz) != cut_offs_hz.end(); }

bool is_divider(int divider) {
  return std::ranges::find(aceinna::PacketRate::dividers, divider) !=
         aceinna::PacketRate::dividers.end();
}

}  // namespace

boost::system::result<device::AceinnaSettings, SettingsError> aceinna_settings(
    const rig_config::AceinnaConfig& config) {
  device::AceinnaSettings settings;
  if (const int rate_hz = config.packet_rate_hz; rate_hz != 0) {
    if (full_rate_hz % rate_hz != 0 || !is_divider(full_rate_hz / rate_hz)) {
      return SettingsError{"aceinna/packet_rate_hz",
                           "aceinna.packet_rate_hz: " + std::to_string(rate_hz) +
                               " is none of its rates; allowed: 100 50 25 20 10 5 4 2"};
    }
    settings.rate_divider = static_cast<std::uint8_t>(full_rate_hz / rate_hz);
  }
  if (!config.slope_message.empty()) {
    constexpr unsigned needed = aceinna::PacketType::rate | aceinna::PacketType::acceleration;
    const unsigned slope = config.slope_message == "on" ? aceinna::PacketType::slope : 0;
    settings.packets = static_cast<std::uint8_t>(needed | slope);
  }
  const int rate_hz = config.rate_filter_hz, acceleration_hz = config.acceleration_filter_hz;
  if (rate_hz >= 0 || acceleration_hz >= 0) {
    if (!is_cut_off(rate_hz) || !is_cut_off(acceleration_hz)) {
      return SettingsError{
          is_cut_off(rate_hz) ? "aceinna/acceleration_filter_hz" : "aceinna/rate_filter_hz",
          "aceinna: rate_filter_hz and acceleration_filter_hz go together, each "
          "one of 0 2 5 10 20 25 40 50"};
    }
    settings.filter = {static_cast<std::uint8_t>(rate_hz),
                       static_cast<std::uint8_t>(acceleration_hz)};
  }
  if (!config.orientation.empty()) {
    const auto axes = aceinna::Axes::of_text(config.orientation);
    if (!axes) {
      return SettingsError{
          "aceinna/orientation",
          "aceinna.orientation: \"" + config.orientation +
              "\" is no right-handed set of axes; allowed: \"+X+Y+Z\" and its turns"};
    }
    settings.orientation = axes->code();
  }
  return settings;
}

boost::system::result<wire::xsens::Identifiers, SettingsError> xsens_identifiers(
    const rig_config::XsensConfig& config) {
  wire::xsens::Identifiers identifiers;
  identifiers.extended = config.extended;
  for (const auto& [message, id] : config.identifiers) {
    if (!identifiers.set(message, id)) {
      return SettingsError{"xsens/identifiers/" + message,
                           "xsens.identifiers: there is no message \"" + message + "\""};
    }
  }
  if (!identifiers.sound()) {
    return SettingsError{"xsens/identifiers",
                         "xsens.identifiers: two are the same, or one is longer than its format; "
                         "allowed: to 0x7FF, with extended = true to 0x1FFFFFFF"};
  }
  return identifiers;
}

}  // namespace drydock::shell
