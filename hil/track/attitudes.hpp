#pragma once

#include <map>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "estimators/smoothing/reading.hpp"
#include "rig_config/rig.hpp"

namespace drydock::track {

/// Roll and pitch of the body, as its compasses and the heads of its DVLs tell them, and the
/// headings of those heads.
class Attitudes {
 public:
  /// The rig must outlive this.
  explicit Attitudes(const rig_config::Rig& rig) : rig_(rig) {}

  void hear(double time_s, const measurement::BottomVelocity& track);
  void hear(double time_s, const measurement::AttitudeSample& sample);

  struct Tilts {
    std::vector<smoothing::Tilt> all;  ///< of one device; times do not decrease
    bool of_dvl = false;
  };
  /// Of the device that told them for longest. A compass counts before a head that is not much
  /// longer.
  Tilts tilts() const;

  struct Heading {
    measurement::Origin origin;
    double rad = 0;  ///< of the body
  };
  /// Of the heads, turned by their mounting: with their own tilts, else with these, else as on a
  /// level body.
  std::vector<Heading> of_heads(const std::vector<smoothing::Tilt>& tilts) const;

 private:
  struct Head {
    double time_s;
    measurement::Origin origin;
    double heading_rad;  ///< of its own axes
    bool has_tilt;
    smoothing::Tilt tilt;  ///< of the body, by its own sensors
  };
  const rig_config::Rig& rig_;
  std::map<std::uint16_t, std::vector<smoothing::Tilt>> tilts_;  ///< by device
  std::vector<Head> heads_;
};

}  // namespace drydock::track
