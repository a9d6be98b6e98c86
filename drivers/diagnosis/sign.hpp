#pragma once

#include <cstdint>
#include <string_view>

namespace drydock::diagnosis {

/// What a monitor can see. A sign is a fact about the data; a cause (cause.hpp) is what the judge
/// makes of the signs of one device.
enum class Sign : std::uint8_t {
  // the line
  silent,           ///< the port is open and nothing comes
  port_lost,        ///< the port hung up or cannot be opened
  bad_checksums,    ///< damaged frames
  foreign_bytes,    ///< bytes between frames, which no frame of the protocol explains
  nothing_decodes,  ///< bytes come, and none is part of a frame
  error_frames,     ///< of the CAN controller
  refuses,          ///< the device refuses a setting
  // time
  rate_low,
  rate_high,
  rate_unexpected,  ///< never the rate that the rig states
  line_full,        ///< a serial line without a pause
  gaps,             ///< single samples are missing from the raster
  bunched,          ///< samples come together
  late,             ///< later than the raster, by a fixed time
  irregular,        ///< arrival times scatter more than before
  clock_step,       ///< the device's clock jumped against arrival
  clock_drift,      ///< the device's clock runs at another rate than arrival
  time_backwards,   ///< device time or counter went back
  repeated,         ///< the same sample twice
  // values
  stuck,
  noisy,
  wild_samples,  ///< single samples beyond what a vehicle can do
  out_of_range,
  values_missing,  ///< no bottom lock, no fix
  step,            ///< jumped and stayed
  // against other sensors
  offset,  ///< differs by a constant
  ramp,    ///< the difference grows
  scale,
  rotated,  ///< its axes are turned
  delayed,  ///< agrees, but with an earlier time
  // the bus
  bus_off,         ///< this computer's controller has left the bus
  bus_taken,       ///< identifiers that were not there before take a large share of the bus
  strange_frames,  ///< many identifiers, each seen once
  address_taken,   ///< another NAME claims the device's address
  // of the device
  swapped,       ///< a message came one place too late, together with its successor
  wild_unequal,  ///< single impossible samples of all sizes, as damaged bits make them
  impossible,    ///< values that no sensor of its kind gives, refused by the driver
  satellites_gone,
  signals_changed,  ///< all satellites are weaker or stronger than they were
  heat,             ///< the device says that it is too hot
  error_report,     ///< the device says that something is wrong with it
  prompts,          ///< bytes come, all of them text, and none is part of a frame
  coarse            ///< the numbers come in coarser steps than before
};

/// How many there are. A set of signs fits one word of 64 bits.
inline constexpr unsigned sign_count = static_cast<unsigned>(Sign::coarse) + 1;
static_assert(sign_count <= 64);

std::string_view to_string(Sign sign);

}  // namespace drydock::diagnosis
