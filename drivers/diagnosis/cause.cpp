#include "drivers/diagnosis/cause.hpp"

#include <array>

namespace drydock::diagnosis {
namespace {

using enum rig_config::FaultKind;
using Kind = rig_config::FaultKind;

// clang-format off
constexpr std::array k_silent{off, hang};
constexpr std::array k_port_lost{unplug, eof};
constexpr std::array k_damaged{flip, flip_header, truncate, bad_checksum};
constexpr std::array k_foreign{garbage};
constexpr std::array k_wrong_baud{wrong_baud};
constexpr std::array k_bus_off{bus_off};
constexpr std::array k_error_frames{error_frames};
constexpr std::array k_bus_load{babbling, bus_load};
constexpr std::array k_stolen{address_stolen};
constexpr std::array k_nak{nak};
constexpr std::array k_drop{drop};
constexpr std::array k_duplicate{duplicate};
constexpr std::array k_reorder{reorder};
constexpr std::array k_delay{delay};
constexpr std::array k_jitter{jitter};
constexpr std::array k_slow{slow};
constexpr std::array k_burst{burst};
constexpr std::array k_clock_step{clock_step};
constexpr std::array k_clock_drift{clock_drift};
constexpr std::array k_stuck{stuck};
constexpr std::array k_bias{bias, wrong};
constexpr std::array k_drift{drift};
constexpr std::array k_noise{noise};
constexpr std::array k_spike{spike};
constexpr std::array k_bottom{bottom_lost};
constexpr std::array k_satellites{satellites_blocked};
constexpr std::array k_antenna{antenna_gain};
constexpr std::array k_hot{hot};

constexpr auto table = std::to_array<CauseFacts>({
    {Cause::silent, "silent", k_silent, "the port is open and nothing comes", "look at the sensor's power and cable", true},
    {Cause::port_lost, "port-lost", k_port_lost, "the port hangs up or cannot be opened", "look at the adapter and its plug; `drydock doctor` lists the ports", true},
    {Cause::damaged, "damaged", k_damaged, "frames arrive damaged", "look at the cable, its length and its ground; try a lower baud rate"},
    {Cause::foreign_bytes, "garbage", k_foreign, "bytes come that belong to no frame", "does another device or a console talk on this line, or does the sensor wait at its prompt?"},
    {Cause::wrong_baud, "wrong-baud", k_wrong_baud, "bytes come and none makes sense", "`drydock probe` finds rate and protocol", true},
    {Cause::bus_off, "bus-off", k_bus_off, "this computer's CAN controller left the bus", "look at termination and bit rate; then set the interface down and up", true},
    {Cause::error_frames, "error-frames", k_error_frames, "the CAN controller sees errors on the bus", "look at termination, ground and bit rate"},
    {Cause::bus_load, "bus-load", k_bus_load, "other nodes take the bus", "find the node that sends most: `drydock monitor` shows identifiers"},
    {Cause::address_stolen, "address-stolen", k_stolen, "another node claims the device's address", "give one of the two another address", true},
    {Cause::nak, "nak", k_nak, "the sensor refuses to be set", "set it with the maker's program, or take the setting out of the rig"},
    {Cause::drop, "drop", k_drop, "messages are lost on the way", "look at the load of line, bus and computer"},
    {Cause::duplicate, "duplicate", k_duplicate, "messages come twice", "look for a repeater or a second gateway"},
    {Cause::reorder, "reorder", k_reorder, "messages change places", "look for a network between sensor and driver"},
    {Cause::delay, "delay", k_delay, "messages come later than they say", "state latency_s, or look for a buffer on the way", true, true},
    {Cause::jitter, "jitter", k_jitter, "messages come at irregular times", "look for a buffer, a gateway or a busy computer", false, false, true},
    {Cause::slow, "slow", k_slow, "the sensor gives fewer samples than it did", "look at the sensor's rate setting"},
    {Cause::burst, "burst", k_burst, "messages are held and come together", "look at the adapter's latency timer and at buffers on the way", false, false, true},
    {Cause::clock_step, "clock-step", k_clock_step, "the sensor's clock jumped", "set the sensor's clock again, or do not use its time", false, false, true},
    {Cause::clock_drift, "clock-drift", k_clock_drift, "the sensor's clock runs at a wrong rate", "do not use its time without synchronisation"},
    {Cause::stuck, "stuck", k_stuck, "the value does not change although its noise must show", "restart the sensor", true, true},
    {Cause::bias, "bias", k_bias, "the value is off by a constant", "calibrate it; look for interference", true, true},
    {Cause::drift, "drift", k_drift, "the value drifts away", "let it warm up; calibrate it", true, true},
    {Cause::noise, "noise", k_noise, "the value is noisier than it was", "look for vibration, bubbles, interference"},
    {Cause::spike, "spike", k_spike, "single samples are impossible", "look at the cable; state a plausible range"},
    {Cause::bottom_lost, "bottom-lost", k_bottom, "no echo from the sea bed", "too deep, too close, or bubbles below the transducers", true},
    {Cause::satellites_blocked, "satellites-blocked", k_satellites, "satellites are hidden", "look at the antenna's view of the sky", true},
    {Cause::antenna_gain, "antenna-gain", k_antenna, "signals have another strength than they had", "look at the antenna and its cable"},
    {Cause::hot, "hot", k_hot, "it is out of the water and hot", "put it into the water, or switch it off", true},
    {Cause::mounting, "mounting", {}, "its axes are turned against the other sensors", "`mounting_deg` of the rig, or the bracket; for tilts `levelled`", true, true},
    {Cause::scale, "scale", {}, "its values are too large or too small by a factor", "sound speed, or the sensor's scale", true, true},
    {Cause::wrong_rate, "wrong-rate", {}, "the rig expects another rate than the sensor gives", "`rate_hz` of the rig, or the sensor's setting"},
    {Cause::line_full, "line-full", {}, "the sensor would say more than its line carries, and so it says it more seldom", "raise the baud rate at both ends, or let the sensor say less"},
    {Cause::device_error, "device-error", {}, "the sensor reports an error of its own, or its node is lost", "look the error up in the sensor's manual; switch it off and on"},
    {Cause::coarse, "coarse", {}, "its numbers come in coarser steps than they did", "look at the sensor's range and output format, and at a gateway that rounds"},
});
// clang-format on

consteval bool stand_in_order() {
  for (std::size_t i = 0; i < table.size(); ++i)
    if (static_cast<std::size_t>(table[i].cause) != i) return false;
  return true;
}
static_assert(stand_in_order(), "the rows stand in the order of Cause, one for each");

}  // namespace

std::span<const CauseFacts> causes() { return table; }
const CauseFacts& facts_of(Cause cause) { return table[static_cast<std::size_t>(cause)]; }

}  // namespace drydock::diagnosis
