#include "rig_config/rules/other_names.hpp"

#include <algorithm>
#include <array>

namespace drydock::rig_config {
namespace {

/// Words of data sheets and of other simulators for the one that stands first.
constexpr std::array words_for_the_same{
    std::array<std::string_view, 4>{"gnss", "gps", "receiver", "glonass"},
    std::array<std::string_view, 4>{"imu", "ins", "gyro", "accelerometer"},
    std::array<std::string_view, 4>{"depth", "pressure", "ctd", "depth_sensor"},
    std::array<std::string_view, 4>{"dvl", "doppler", "adcp", "bottom_track"},
    std::array<std::string_view, 4>{"emlog", "log", "speed_log", "paddlewheel"},
    std::array<std::string_view, 4>{"attitude", "ahrs", "compass", "mru"},
    std::array<std::string_view, 4>{"actuator", "thruster", "rudder", "motor"},
    std::array<std::string_view, 4>{"off", "dead", "power-off", "power_loss"},
    std::array<std::string_view, 4>{"hang", "silent", "silence", "stop"},
    std::array<std::string_view, 4>{"stuck", "freeze", "frozen", "constant"},
    std::array<std::string_view, 4>{"bias", "offset", "shift", "error"},
    std::array<std::string_view, 4>{"spike", "outlier", "outliers", "glitch"},
    std::array<std::string_view, 4>{"drop", "dropout", "loss", "packet-loss"},
    std::array<std::string_view, 4>{"delay", "latency", "lag", "late"},
    std::array<std::string_view, 4>{"unplug", "disconnect", "unplugged", "cut"},
};

}  // namespace

const std::string* other_name_of(std::string_view lower, std::span<const std::string> known) {
  for (const auto& words : words_for_the_same) {
    if (std::ranges::find(words, lower) == words.end()) continue;
    const auto found = std::ranges::find(known, words.front());
    if (found != known.end()) return &*found;
  }
  return nullptr;
}

}  // namespace drydock::rig_config
