#pragma once

#include <string>
#include <string_view>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"
#include "hil/emulate/dvl/water_linked_range_mode.hpp"

namespace drydock::emulate {

/// What a host can set on a Water Linked DVL by `set_config`. They are those of its maker at first.
class WaterLinkedJsonSettings {
 public:
  using Configuration = wire::water_linked_json::Configuration;

  WaterLinkedJsonSettings();

  /// Takes the JSON object of parameters. Returns why it refuses all of them; empty: it took them.
  std::string_view set(std::string_view parameters);

  Configuration configuration() const;
  bool acoustic_enabled() const { return *configuration_.acoustic_enabled; }
  double mounting_rotation_rad() const { return *configuration_.mounting_rotation_rad; }
  /// Empty until a host sets it: the DVL then knows the right one.
  std::optional<double> sound_speed_mps() const;
  const RangeMode& mode() const { return mode_; }

 private:
  void take(const Configuration& wanted);

  Configuration configuration_;
  std::string range_mode_ = "auto";
  RangeMode mode_;
  bool sound_is_set_ = false;
};

/// The answer to `get_time_status`: JSON, the time in RFC 3339, UTC.
std::string water_linked_time_status(measurement::Stamp device_time);

}  // namespace drydock::emulate
