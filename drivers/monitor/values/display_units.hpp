#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/monitor/values/shown_value.hpp"

namespace drydock::monitor {

/// One way to show a quantity: shown = factor * value + offset.
struct DisplayUnit {
  std::string_view name;
  std::string_view ending;  ///< of the fields of that quantity: "_mps"
  double factor = 1, offset = 0;
  int decimals = 3;
};

/// How a person wants to read the numbers. Without a choice: m/s, kPa, °C, deg, r/min, m.
class DisplayUnits {
 public:
  /// `names`: "kn,bar". Throws std::invalid_argument with the allowed ones for any other name.
  static DisplayUnits of(std::string_view names);
  static std::string allowed();  ///< all names, comma-separated

  /// The value of a field whose name ends with its unit. A NaN among the numbers shows as "-".
  ShownValue shown(std::string_view field, std::span<const double> numbers) const;

 private:
  const DisplayUnit* unit_of(std::string_view field) const;

  std::vector<const DisplayUnit*> chosen_;
};

/// "08:00:12.345" in UTC of seconds since 1970.
std::string clock_text(double utc_s, int decimals = 3);

/// The time of a device's own clock: as clock_text where it counts from 1970, else its seconds.
std::string device_clock_text(double device_time_s);

}  // namespace drydock::monitor
