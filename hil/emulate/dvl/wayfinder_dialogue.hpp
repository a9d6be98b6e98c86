#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::emulate {

/// What a host sets on a Wayfinder; the defaults are those of the maker's programs.
struct WayfinderSetup {
  bool software_trigger = false;
  unsigned baud_type = 7;  ///< 3: 9600 baud, 7: 115200
  float sound_speed_mps = 1500, longest_range_m = 60;
};

/// The binary commands of a Wayfinder. It pings from power on until it is told to stop. While it
/// pings it takes no clock and no setup, but a speed of sound.
class WayfinderDialogue {
 public:
  using Clock = std::chrono::seconds;  ///< since 1970, as the DVL's clock shows it

  /// The payload of the answer to the payload of a command. A DVL that `refuses` starts, stops and
  /// sets nothing.
  std::vector<std::uint8_t> answer(wire::Bytes command, Clock now, bool refuses);

  bool pings() const { return pings_; }
  const WayfinderSetup& setup() const { return setup_; }
  Clock clock_offset() const { return clock_offset_; }  ///< that a host has set
  bool take_trigger();  ///< true if one ping was asked for and not yet sent

 private:
  enum class Status : std::uint8_t;
  enum class Trouble : std::uint8_t;
  Status obey(std::uint32_t command, wire::Bytes parameters, Clock now);
  Status set_clock(wire::Bytes parameters, Clock now);
  Status set_setup(wire::Bytes parameters);
  Status set_sound_speed(wire::Bytes parameters);
  Status wrong(Trouble trouble);

  WayfinderSetup setup_;
  Clock clock_offset_{0};
  bool pings_ = true, triggered_ = false;
  Trouble trouble_{};
};

}  // namespace drydock::emulate
