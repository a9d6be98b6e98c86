#pragma once

#include <utility>

#include "hil/motion/truth.hpp"

namespace drydock::motion::test {

/// An ocean with the truth's current at all depths and a plane bed at its depth.
inline rig_config::OceanConfig ocean_of(const Truth& truth) {
  const Eigen::Vector3d& v = truth.current_ned;
  rig_config::OceanConfig config;
  config.bed.depth_m = truth.bed_depth_m;
  config.current = {{0, {v.x(), v.y(), v.z()}}};
  return config;
}

/// The same truth at all times.
class Frozen : public Trajectory {
 public:
  explicit Frozen(Truth truth, Stamp start = {}) : Frozen(truth, ocean_of(truth), start) {}
  Frozen(Truth truth, const rig_config::OceanConfig& ocean, Stamp start = {})
      : truth_(std::move(truth)),
        ocean_(ocean, {truth_.latitude_rad, truth_.longitude_rad, 0}),
        start_(start) {}

  Truth at(Stamp time) const override {
    Truth truth = truth_;
    truth.at = time;
    return truth;
  }
  Stamp start() const override { return start_; }
  Stamp end() const override { return start_; }
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  Truth truth_;
  ocean::Ocean ocean_;
  Stamp start_;
};

}  // namespace drydock::motion::test
