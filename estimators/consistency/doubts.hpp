#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "estimators/consistency/devices.hpp"
#include "estimators/consistency/sensor.hpp"

namespace drydock::consistency {

using measurement::Stamp;

/// Which devices are no reference now, and since when what they said is doubtful.
class Doubts {
 public:
  explicit Doubts(const std::vector<Sensor>& sensors) : of_(sensors.size()) {
    using measurement::Kind;
    for (std::size_t i = 0; i < sensors.size(); ++i)
      of_[i].tells_motion = sensors[i].kind == Kind::dvl || sensors[i].kind == Kind::imu;
  }

  /// The device's own samples show that it is wrong, whatever others say.
  void note_own(std::uint16_t device, Stamp since, Stamp now) {
    One& one = of_.at(device);
    one.own_since = now > one.own_until ? since : std::min(one.own_since, since);
    one.own_until = now + own_memory;
  }

  /// Those of the time that is tested now: the ones with own doubts, until others are added.
  void begin(Stamp at) {
    for (One& one : of_) {
      one.before = one.since.has_value();
      one.own_before = one.own;
      one.own = one.guilty = one.own_since <= at && at < one.own_until;
      one.since = one.own ? std::optional(one.own_since) : std::nullopt;
    }
  }
  /// Other evidence tells it: it explains the tests that accuse it together with others.
  void note_guilty(std::uint16_t device) { of_[device].guilty = true; }
  void add(std::uint16_t device, Stamp since) {
    auto& known = of_[device].since;
    known = std::min(known.value_or(since), since);
  }

  /// Its own samples show that it is wrong.
  bool is_own(std::uint16_t device) const { return of_[device].own; }
  /// Its own samples showed until now that it was wrong: since when.
  std::optional<Stamp> own_is_over(std::uint16_t device) const {
    const One& one = of_[device];
    return one.own_before && !one.own ? std::optional(one.own_since) : std::nullopt;
  }
  /// It was doubtful until now.
  bool is_over(std::uint16_t device) const { return of_[device].before && !has(device); }

  bool has(std::uint16_t device) const { return of_[device].since.has_value(); }
  /// One of them tells how the vehicle moves, and is doubtful.
  bool tells_motion(const Devices& devices) const {
    return std::ranges::any_of(
        devices, [&](std::uint16_t device) { return has(device) && of_[device].tells_motion; });
  }
  bool is_guilty(std::uint16_t device) const { return of_[device].guilty; }
  /// Since when a device is doubtful, if that is news.
  std::optional<Stamp> news(std::uint16_t device) const {
    return of_[device].before ? std::nullopt : of_[device].since;
  }
  /// Since when a device that tells how the vehicle moves is doubtful, if that is news.
  std::optional<Stamp> news() const {
    std::optional<Stamp> first;
    for (const One& one : of_)
      if (one.tells_motion && !one.before && one.since)
        first = std::min(first.value_or(*one.since), *one.since);
    return first;
  }

 private:
  struct One {
    std::optional<Stamp> since;
    bool tells_motion = false;             ///< DVLs and inertial units do
    bool before = false;                   ///< it was doubtful at the last time
    bool own = false, own_before = false;  ///< its own samples show it: now, at the last time
    bool guilty = false;                   ///< they do, or it was off from the start
    Stamp own_since{}, own_until{};
  };
  /// A fault that strikes one sample in ten shows again meanwhile.
  static constexpr std::chrono::seconds own_memory{10};

  std::vector<One> of_;
};

}  // namespace drydock::consistency
