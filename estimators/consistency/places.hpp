#pragma once

#include <array>
#include <span>

#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// The position of each receiver against the sum of its own velocity.
class Places {
 public:
  explicit Places(const Tracks& tracks);
  void step(const Moment& moment);

  struct Receiver {
    std::uint16_t device;
    const Freeze* freeze;
    std::array<Test, 2> tests;  ///< north, east
    Eigen::Vector2d travelled = Eigen::Vector2d::Zero(), last_velocity = Eigen::Vector2d::Zero();
    Stamp last{};
    std::uint64_t serial = 0;
  };
  std::span<const Receiver> receivers() const { return receivers_; }

 private:
  void step(Receiver& receiver, const GnssTracks& tracks, const Moment& moment);

  const Tracks& tracks_;
  std::vector<Receiver> receivers_;
};

}  // namespace drydock::consistency
