#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hil/emulate/dvl/ad2cp_settings.hpp"

namespace drydock::emulate {

/// The command line of a Nortek DVL. It measures from power on, and then hears only the break
/// (K1W%!Q or Ctrl-C), and BBPWAKEUP with one line after it. START makes it measure again. Each
/// line is answered with OK or ERROR; GETERROR tells why.
class Ad2cpDialogue {
 public:
  /// Takes bytes of the host and returns what the DVL says to them. A DVL that `refuses` takes no
  /// settings and does not start.
  std::string receive(std::span<const std::uint8_t> bytes, bool refuses);

  bool measures() const { return measures_; }
  /// True if records go to the line while it measures.
  bool puts_out() const { return telemetry_.enabled.value != 0 && telemetry_.to_line.value != 0; }
  double range_m() const { return bottom_track_.range.value; }

 private:
  std::string obey_line(bool refuses);
  std::string obey(std::string_view command, std::string_view arguments);
  std::string taken();
  std::string failed(std::string why);
  std::string set(std::span<Ad2cpArgument* const> arguments, std::string_view text);
  std::string tell(std::span<Ad2cpArgument* const> arguments, std::string_view text);
  std::string start(bool measures);

  Ad2cpBottomTrackSettings bottom_track_;
  Ad2cpTelemetrySettings telemetry_;
  std::string line_, last_error_;
  bool measures_ = true, awake_ = false;
};

}  // namespace drydock::emulate
