#pragma once

#include <ostream>

#include "drivers/wire/described/frame_codec.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Each shipped description of CAN frames, with golden frames that others made.
namespace drydock::described::test {

struct GoldenBus {
  std::string file;
  std::string folder;                    ///< of the frames, in fixtures
  std::size_t messages = 0, shorts = 0;  ///< of the description; and frames that end too early

  std::vector<wire::CanFrame> frames() const {
    return wire::test::frames_of_log(wire::test::fixture(folder + "/frames.log"));
  }
};

/// The NOTE.md of each folder tells where the frames are from.
inline const std::vector<GoldenBus>& golden_buses() {
  static const std::vector<GoldenBus> all{{"n2k-compass-dbc.toml", "nmea2000", 6, 1},
                                          {"xsens-dbc.toml", "xsens", 5, 0},
                                          {"mv5-dbc.toml", "microstrain-mv5", 4, 0}};
  return all;
}

inline std::ostream& operator<<(std::ostream& out, const GoldenBus& one) { return out << one.file; }

}  // namespace drydock::described::test
