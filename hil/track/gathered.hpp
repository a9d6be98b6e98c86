#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/sound_speed_used.hpp"
#include "drivers/measurement/stamp.hpp"
#include "estimators/frame/geodetic.hpp"
#include "estimators/smoothing/noise_fit.hpp"
#include "rig_config/rig.hpp"

namespace drydock::track {

/// The truth of an emulated vehicle at one time.
struct TruthPoint {
  double time_s = 0;
  frame::Position position;
};

/// All that a recording or a capture holds for a track.
struct Gathered {
  std::string source;  ///< as the person typed it
  rig_config::Rig rig;
  std::string rig_text;        ///< the rig file; empty: a capture
  measurement::Stamp start{};  ///< time zero of the dive
  measurement::Stamp utc{};    ///< the same, as a receiver tells it where the capture does not
  smoothing::Dive dive;
  std::vector<smoothing::UnstatedNoise>
      unstated;  ///< sensors that do not say how accurate they are
  /// They are those of the DVL's own sensors.
  bool own_heading = false, own_tilts = false, own_depth = false;
  std::vector<TruthPoint> truth;
  std::map<std::uint16_t, double> sound_speed_mps;             ///< that DVLs used, by device
  std::map<std::uint16_t, measurement::SoundSpeedUsed> water;  ///< that DVLs told, by device
  std::map<std::string, std::uint64_t> passed_over;  ///< values that no track can use, by reason
  std::vector<std::string> notes;                    ///< sentences for a person

  std::string device_name(std::uint16_t device) const {
    return device < rig.devices.size() ? rig.devices[device].name : "device";
  }
};

}  // namespace drydock::track
