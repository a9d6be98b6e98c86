#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drivers/diagnosis/monitors/antenna.hpp"
#include "estimators/consistency/constants.hpp"
#include "estimators/consistency/moment.hpp"

namespace drydock::consistency {

/// Whether a receiver lost its fix in a dive, where no pressure sensor tells it: a DVL tells how
/// far the vehicle went down meanwhile.
class Dives {
 public:
  static constexpr double patience_s = 10;    ///< from the last fix to the verdict
  static constexpr double mean_s = 5;         ///< waves are taken out of both depths so
  static constexpr double deep_m = 0.3;       ///< deeper by so much it is a dive,
  static constexpr double wander_mps = 0.03;  ///< and by so much more for each second behind that
  /// What moves faster over ground is no vehicle under water, nor about to be one.
  static constexpr double no_diver_mps = 25;

  Dives(const Tracks& tracks, const Constants& constants);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    std::optional<double> down_mps;
    for (std::size_t i = 0; i < tracks_.dvls.size() && !down_mps; ++i)
      if (!distrusted(Devices{tracks_.dvls[i].device})) down_mps = velocity_down(i, moment);
    go_on(down_mps, moment.dt);
    for (Receiver& receiver : receivers_) follow(receiver, moment);
  }

  /// Known from the verdict until the next fix.
  diagnosis::Antenna antenna(std::uint16_t receiver) const;

 private:
  struct Receiver {
    std::size_t track;
    diagnosis::Antenna antenna = diagnosis::Antenna::unknown;
    std::optional<double> before_m{};  ///< the depth about the last fix
    double without_fix_s = 0;
  };
  std::optional<double> velocity_down(std::size_t dvl, const Moment& moment) const;
  void go_on(std::optional<double> down_mps, double dt);
  void follow(Receiver& receiver, const Moment& moment) const;
  std::optional<double> mean_depth_m() const;

  const Tracks& tracks_;
  const Constants& constants_;
  std::vector<Receiver> receivers_;
  std::array<double, 25> depths_m_{};  ///< of the last steps, from any zero
  std::size_t known_ = 0;              ///< steps without a gap
  double depth_m_ = 0;
};

}  // namespace drydock::consistency
