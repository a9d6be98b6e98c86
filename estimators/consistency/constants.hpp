#pragma once

#include <optional>
#include <vector>

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/constant_fit.hpp"
#include "estimators/consistency/moment.hpp"

namespace drydock::consistency {

/// Errors of a DVL that were there from the start, which no change shows: its axes are pitched, its
/// tilts are used twice or not at all, its scale is wrong. Each is fitted to means over `window`.
class Constants {
 public:
  static constexpr std::chrono::seconds window{10};

  explicit Constants(const Tracks& tracks);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    const auto depth = depth_of(moment, distrusted);
    const auto speed_mps = speed(moment, distrusted);
    for (Dvl& dvl : dvls_)
      if (distrusted(Devices{dvl.device}))
        dvl.begun = {};
      else
        step(dvl, moment, depth ? depth : own_depth(tracks_.dvls[dvl.track], moment.at), speed_mps);
  }

  /// What a DVL's velocity down lacks by these errors, as far as they are known now, m/s.
  double missing_down(std::size_t dvl, const Eigen::Vector3d& velocity,
                      const Eigen::Vector3d& down) const {
    return dvls_[dvl].known.dot(terms(velocity, down));
  }

  /// Repeats the signs that last. `scales`: no third sensor has told whose speed is off.
  void tell(Stamp now, diagnosis::SymptomSink& to, bool scales = true) const;

 private:
  /// `late_s`: 1 sigma of the unknown latency of a sensor against the DVL.
  struct Depth {
    double m = 0, late_s = 0;
  };
  /// Sums of one window. Where it begins or ends in a dive, depth and sum are not of one time.
  struct Sums {
    Stamp last{};
    double begun_mps = 0, last_mps = 0;  ///< velocity down
    double down_m = 0, over_ground_m = 0, receiver_m = 0, depth_m = 0;
    Eigen::Vector3d terms_s = Eigen::Vector3d::Zero();
    bool deep = false, fixed = false;  ///< depth, GNSS velocity came all the time
  };
  struct Dvl {
    std::uint16_t device;
    std::size_t track;
    std::optional<Stamp> begun{};
    Stamp first{};
    Sums sums{};
    bool tilts_told = false;  ///< then half of it is told still
    ConstantFit<3> vertical;
    ConstantFit<1> scale;
    ConstantFit<3>::Answer constant{};                ///< of `vertical`, as of its last window
    Eigen::Vector3d known = Eigen::Vector3d::Zero();  ///< of it, what is no noise
    ConstantFit<1>::Answer factor{};                  ///< of `scale`
  };

  static constexpr double unknown_latency_s = 0.14;  ///< 0.1 s of each of the two

  /// Of a pressure sensor. Without one, each head may tell its own.
  template <class Distrusted>
  std::optional<Depth> depth_of(const Moment& moment, const Distrusted& distrusted) const {
    for (const auto& depth : tracks_.depths)
      if (!distrusted(Devices{depth.device}))
        if (const auto read = depth.depth.at(moment.at))
          return Depth{
              read->value.x() - (moment.down ? moment.down->dot(depth.sensor.lever_arm_m) : 0),
              unknown_latency_s};
    return {};
  }
  static std::optional<Depth> own_depth(const DvlTracks& dvl, Stamp at) {
    const auto depth_m = dvl.living_depth(at);
    if (!depth_m) return {};
    return Depth{*depth_m};
  }
  /// Of the antenna, along the sea.
  template <class Distrusted>
  std::optional<double> speed(const Moment& moment, const Distrusted& distrusted) const {
    for (const auto& receiver : tracks_.receivers)
      if (!distrusted(Devices{receiver.device}))
        if (const auto read = receiver.velocity.at(moment.at)) return read->value.norm();
    return {};
  }
  void step(Dvl& dvl, const Moment& moment, const std::optional<Depth>& depth,
            std::optional<double> speed_mps);
  void end(Dvl& dvl, const Depth& depth) const;
  /// A DVL that is pitched by p reads p u too little down; tilts that are used once too often or
  /// too seldom add or take the climb.
  static Eigen::Vector3d terms(const Eigen::Vector3d& velocity, const Eigen::Vector3d& down) {
    return {1, velocity.x(), -velocity.x() * down.x()};
  }

  const Tracks& tracks_;
  std::vector<Dvl> dvls_;
};

}  // namespace drydock::consistency
