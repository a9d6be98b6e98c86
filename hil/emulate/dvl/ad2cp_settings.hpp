#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The settings that a Nortek DVL's commands SETBT, GETBT, SETTMBT and GETTMBT name. Source:
/// Nortek, Signature Integrator's Guide 2017 and DVL manual 2017. The limits are those of this
/// emulation.
namespace drydock::emulate {

struct Ad2cpArgument {
  std::string_view name;
  double value, lowest, highest;
  int decimals;
};

/// Of bottom track: m, m/s, number of beams, which ones, data format, dB.
struct Ad2cpBottomTrackSettings {
  Ad2cpArgument range{"RANGE", 75, 0.2, 75, 2}, velocity_range{"VR", 5, 5, 10, 2},
      beams{"NB", 4, 4, 4, 0}, selection{"CH", 1234, 1234, 1234, 0}, format{"DF", 21, 21, 22, 0},
      power{"PL", 0, -20, 0, 1};

  std::array<Ad2cpArgument*, 6> arguments() {
    return {&range, &velocity_range, &beams, &selection, &format, &power};
  }
};

/// Of its output: whether there is any, to a file, to the line; data format.
struct Ad2cpTelemetrySettings {
  Ad2cpArgument enabled{"EN", 1, 0, 1, 0}, to_file{"FO", 0, 0, 1, 0}, to_line{"SO", 1, 0, 1, 0},
      format{"DF", 21, 21, 22, 0};

  std::array<Ad2cpArgument*, 4> arguments() { return {&enabled, &to_file, &to_line, &format}; }
};

/// Sets "NAME=value,NAME=value", all or nothing. Returns why not; empty: it is set.
std::string set_arguments(std::span<Ad2cpArgument* const> arguments, std::string_view text);

/// The values that "NAME,NAME" asks for, or all of them, separated by commas. Empty: a name is not
/// known.
std::optional<std::string> values_of(std::span<Ad2cpArgument* const> arguments,
                                     std::string_view text);

}  // namespace drydock::emulate
