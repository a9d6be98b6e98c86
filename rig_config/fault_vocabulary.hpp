#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

/// The vocabulary of faults: one row holds every fact about a word. docs/build/add-a-fault.md
namespace drydock::rig_config {

/// In the order of the vocabulary, layer by layer.
enum class FaultKind : std::uint8_t {
  // clang-format off
  off, stuck, bias, drift, noise, wrong, spike,
  drop, flip, flip_header, truncate, bad_checksum, duplicate, reorder, garbage,
  unplug, hang, wrong_baud, eof, bus_off, error_frames, babbling, address_stolen, bus_load, nak,
  delay, jitter, slow, burst, clock_step, clock_drift,
  bottom_lost, satellites_blocked, antenna_gain, hot
  // clang-format on
};

enum class FaultLayer : std::uint8_t { measurement, message, link, time, environment };

/// What a device must have so that the fault can affect it. fault_refusal.cpp says how to tell.
enum class FaultNeed : std::uint8_t {
  nothing,
  byte_stream,
  checksum,
  port,
  baud_rate,
  can_bus,
  j1939,
  settings,
  noise,
  own_clock,
  sea_bed,
  heat,
  satellites
};

/// A further key of a fault beside its amount.
struct FaultExtra {
  std::string_view key;  ///< unit in the name
  double usual = 0, lowest = 0, highest = 0;
};

/// The facts that only some words have.
struct FaultFacts {
  FaultNeed needs = FaultNeed::nothing;
  /// Only an emulated device can do it. This holds for all measurement and environment faults.
  bool emulated_only = false;
  std::optional<FaultExtra> extra{};
  std::string_view scorecard{};  ///< lines of the fault file if `usual` does not suit a scorecard
};

/// One word of the vocabulary. `amount` is the key of its size, with the unit in the name.
/// "quantity" stands for the key of the measured quantity (velocity_mps, rate_degps, ...).
struct FaultWord {
  FaultKind kind;
  FaultLayer layer;
  std::string_view name;  ///< in files and on the command line: "bad-checksum"
  std::string_view amount;
  double usual = 0, lowest = 0, highest = 0;  ///< of the amount; NaN: it must be given
  std::string_view meaning;
  FaultFacts facts{};
};

namespace words {

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();
inline constexpr double any = 1e9, hour = 3600;

using enum FaultKind;
using enum FaultLayer;
using Need = FaultNeed;

// clang-format off
inline constexpr auto vocabulary = std::to_array<FaultWord>({
    {off, measurement, "off", "", 0, 0, 0, "without power; it boots anew at the end"},
    {stuck, measurement, "stuck", "", 0, 0, 0, "goes on reporting its last reading"},
    {bias, measurement, "bias", "quantity", required, -any, any, "reads too much by so much"},
    {drift, measurement, "drift", "quantity", required, -any, any, "a bias that grows to so much within within_s",
     {.extra{{"within_s", 60, 0, any}}}},
    {noise, measurement, "noise", "times", 10, 0, 1e6, "its white noise so many times as strong", {.needs = Need::noise}},
    {wrong, measurement, "wrong", "quantity", required, -any, any, "reports so much, whatever it measures"},
    {spike, measurement, "spike", "quantity", required, -any, any, "single samples are off by so much",
     {.extra{{"probability", 1, 0, 1}}}},

    {drop, message, "drop", "probability", 0.2, 0, 1, "messages are lost"},
    {flip, message, "flip", "probability", 0.2, 0, 1, "one bit of a message is turned over"},
    {flip_header, message, "flip-header", "probability", 0.2, 0, 1, "one bit of a message's first six bytes is turned over: sync, kind, length",
     {.needs = Need::byte_stream}},
    {truncate, message, "truncate", "probability", 0.2, 0, 1, "a message ends early"},
    {bad_checksum, message, "bad-checksum", "probability", 0.2, 0, 1, "a message's checksum is wrong", {.needs = Need::checksum}},
    {duplicate, message, "duplicate", "probability", 0.2, 0, 1, "a message comes twice"},
    {reorder, message, "reorder", "probability", 0.2, 0, 1, "a message comes after its successor"},
    {garbage, message, "garbage", "bytes", 16, 1, 4096, "random bytes, or frames, between messages",
     {.extra{{"probability", 1, 0, 1}}, .scorecard = "probability = 0.2"}},

    {unplug, link, "unplug", "", 0, 0, 0, "the port is gone", {.needs = Need::port}},
    {hang, link, "hang", "", 0, 0, 0, "the port is open, nothing comes and nothing is heard"},
    {wrong_baud, link, "wrong-baud", "baud", required, 300, 4e6, "the device talks at another baud rate", {.needs = Need::baud_rate}},
    {eof, link, "eof", "", 0, 0, 0, "the port hangs up once and can be opened again at once", {.needs = Need::port}},
    {bus_off, link, "bus-off", "", 0, 0, 0, "the drivers' CAN controller is bus-off", {.needs = Need::can_bus}},
    {error_frames, link, "error-frames", "rate_hz", 10, 0.01, 1000, "CAN error frames", {.needs = Need::can_bus}},
    {babbling, link, "babbling", "", 0, 0, 0, "a node sends its highest priority all the time",
     {.needs = Need::can_bus, .emulated_only = true}},
    {address_stolen, link, "address-stolen", "", 0, 0, 0, "another J1939 node claims the device's address",
     {.needs = Need::j1939, .emulated_only = true}},
    {bus_load, link, "bus-load", "share", 0.5, 0.01, 0.99, "other nodes take such a share of the bus",
     {.needs = Need::can_bus, .emulated_only = true, .scorecard = "share = 0.9"}},
    {nak, link, "nak", "", 0, 0, 0, "it refuses to be set", {.needs = Need::settings, .emulated_only = true}},

    {delay, time, "delay", "seconds", 0.5, 0, hour, "messages come later"},
    {jitter, time, "jitter", "seconds", 0.05, 0, hour, "messages come later by a random time, in order",
     {.scorecard = "seconds = 0.2"}},
    {slow, time, "slow", "times", 2, 1, 1000, "so many times fewer samples", {.emulated_only = true}},
    {burst, time, "burst", "seconds", 1, 0.001, hour, "messages are held and come together"},
    {clock_step, time, "clock-step", "seconds", required, -any, any, "the device's clock jumps",
     {.needs = Need::own_clock, .emulated_only = true, .scorecard = "seconds = 10"}},
    {clock_drift, time, "clock-drift", "ppm", 100, -1e5, 1e5, "the device's clock is too fast", {.emulated_only = true}},

    {bottom_lost, environment, "bottom-lost", "", 0, 0, 0, "no echo from the sea bed", {.needs = Need::sea_bed}},
    {satellites_blocked, environment, "satellites-blocked", "below_deg", 90, 0, 90, "none is seen below such an elevation",
     {.needs = Need::satellites}},
    {antenna_gain, environment, "antenna-gain", "db", -10, -60, 20, "signals are stronger by so much", {.needs = Need::satellites}},
    {hot, environment, "hot", "seconds", 20, 0, hour, "out of the water and hot: it shuts down after so long", {.needs = Need::heat}},
});
// clang-format on

/// True if each word stands at the place of its kind. word_of() relies on it.
consteval bool stand_in_order() {
  for (std::size_t i = 0; i < vocabulary.size(); ++i)
    if (static_cast<std::size_t>(vocabulary[i].kind) != i) return false;
  return true;
}
static_assert(stand_in_order(), "the rows stand in the order of FaultKind, one for each");

}  // namespace words

constexpr std::span<const FaultWord> fault_vocabulary() { return words::vocabulary; }

/// A kind without a row does not compile as a constant and throws at run time.
constexpr const FaultWord& word_of(FaultKind kind) {
  return words::vocabulary.at(static_cast<std::size_t>(kind));
}

const FaultWord* find_fault(std::string_view name);  ///< nullptr: no such word
std::string_view name_of(FaultLayer layer);

}  // namespace drydock::rig_config
