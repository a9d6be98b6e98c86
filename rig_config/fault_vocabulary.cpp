#include <algorithm>
#include <limits>

#include "rig_config/fault_extra.hpp"

namespace drydock::rig_config {

namespace {

constexpr double required = std::numeric_limits<double>::quiet_NaN();
constexpr double any = 1e9, hour = 3600;

using enum FaultKind;
using enum FaultLayer;

// clang-format off
constexpr FaultWord vocabulary[] = {
    {off, measurement, "off", "", 0, 0, 0, "without power; it boots anew at the end"},
    {stuck, measurement, "stuck", "", 0, 0, 0, "goes on reporting its last reading"},
    {bias, measurement, "bias", "quantity", required, -any, any, "reads too much by so much"},
    {drift, measurement, "drift", "quantity", required, -any, any, "a bias that grows to so much within within_s"},
    {noise, measurement, "noise", "times", 10, 0, 1e6, "its white noise so many times as strong"},
    {wrong, measurement, "wrong", "quantity", required, -any, any, "reports so much, whatever it measures"},
    {spike, measurement, "spike", "quantity", required, -any, any, "single samples are off by so much"},

    {drop, message, "drop", "probability", 0.2, 0, 1, "messages are lost"},
    {flip, message, "flip", "probability", 0.2, 0, 1, "one bit of a message is turned over"},
    {truncate, message, "truncate", "probability", 0.2, 0, 1, "a message ends early"},
    {bad_checksum, message, "bad-checksum", "probability", 0.2, 0, 1, "a message's checksum is wrong"},
    {duplicate, message, "duplicate", "probability", 0.2, 0, 1, "a message comes twice"},
    {reorder, message, "reorder", "probability", 0.2, 0, 1, "a message comes after its successor"},
    {garbage, message, "garbage", "bytes", 16, 1, 4096, "random bytes, or frames, between messages"},

    {unplug, link, "unplug", "", 0, 0, 0, "the port is gone"},
    {hang, link, "hang", "", 0, 0, 0, "the port is open, nothing comes and nothing is heard"},
    {wrong_baud, link, "wrong-baud", "baud", required, 300, 4e6, "the device talks at another baud rate"},
    {eof, link, "eof", "", 0, 0, 0, "the port hangs up once and can be opened again at once"},
    {bus_off, link, "bus-off", "", 0, 0, 0, "the drivers' CAN controller is bus-off"},
    {error_frames, link, "error-frames", "rate_hz", 10, 0.01, 1000, "CAN error frames"},
    {babbling, link, "babbling", "", 0, 0, 0, "a node sends its highest priority all the time"},
    {address_stolen, link, "address-stolen", "", 0, 0, 0, "another J1939 node claims the device's address"},
    {bus_load, link, "bus-load", "share", 0.5, 0.01, 0.99, "other nodes take such a share of the bus"},
    {nak, link, "nak", "", 0, 0, 0, "it refuses to be set"},

    {delay, time, "delay", "seconds", 0.5, 0, hour, "messages come later"},
    {jitter, time, "jitter", "seconds", 0.05, 0, hour, "messages come later by a random time, in order"},
    {slow, time, "slow", "times", 2, 1, 1000, "so many times fewer samples"},
    {burst, time, "burst", "seconds", 1, 0.001, hour, "messages are held and come together"},
    {clock_step, time, "clock-step", "seconds", required, -any, any, "the device's clock jumps"},
    {clock_drift, time, "clock-drift", "ppm", 100, -1e5, 1e5, "the device's clock is too fast"},

    {bottom_lost, environment, "bottom-lost", "", 0, 0, 0, "no echo from the sea bed"},
    {satellites_blocked, environment, "satellites-blocked", "below_deg", 90, 0, 90, "none is seen below such an elevation"},
    {antenna_gain, environment, "antenna-gain", "db", -10, -60, 20, "signals are stronger by so much"},
    {hot, environment, "hot", "seconds", 20, 0, hour, "out of the water and hot: it shuts down after so long"},
};
// clang-format on

constexpr FaultExtra of_each_one[] = {{"probability", 1, 0, 1}};
constexpr FaultExtra of_growth[] = {{"within_s", 60, 0, any}};

}  // namespace

std::span<const FaultWord> fault_vocabulary() { return vocabulary; }

const FaultWord& word_of(FaultKind kind) { return vocabulary[static_cast<std::size_t>(kind)]; }

std::span<const FaultExtra> extras_of(FaultKind kind) {
  if (kind == spike || kind == garbage) return of_each_one;
  if (kind == drift) return of_growth;
  return {};
}

const FaultWord* find_fault(std::string_view name) {
  const auto* found = std::ranges::find(vocabulary, name, &FaultWord::name);
  return found == std::end(vocabulary) ? nullptr : found;
}

std::string_view name_of(FaultLayer layer) {
  constexpr std::array<std::string_view, 5> names{"measurement", "message", "link", "time",
                                                  "environment"};
  return names.at(static_cast<std::size_t>(layer));
}

}  // namespace drydock::rig_config
