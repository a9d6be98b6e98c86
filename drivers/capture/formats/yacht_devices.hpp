#pragma once

#include "drivers/capture/reader.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// The RAW lines of Yacht Devices' gateways: time of day, R from the bus or T to it, identifier,
/// data. Source: manual of the YDWG-02, appendix E.
///    17:33:21.107 R 19F51323 01 2F 30 70 00 2F 30 70
class YachtDevices final : public LineReader {
 public:
  static constexpr std::string_view name = "ydwg";
  static bool recognises(std::string_view line);

 private:
  Reading read_line(std::string_view line) override;

  wire::DayClock clock_;
};

}  // namespace drydock::capture
