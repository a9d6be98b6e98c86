#pragma once

#include <string>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// CRTD, the log of the Open Vehicle Monitoring System, which SavvyCAN writes too: seconds since
/// 1970 or since the start, direction and bits of the identifier with the bus in front, identifier,
/// data. Source: docs.openvehicles.com/en/latest/crtd.
///    1542473901.020305 1R11 7ED 04 41 0C 00 00 AA AA AA
/// Records of another type (CXX, CEV and so on) are remarks. Bus n is interface can(n-1); without a
/// number it is the first.
class Crtd final : public LineReader {
 public:
  static constexpr std::string_view name = "crtd";
  static bool recognises(std::string_view line);

 private:
  Reading read_line(std::string_view line) override;
  std::string interface_;
};

}  // namespace drydock::capture
