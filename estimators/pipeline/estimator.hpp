#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/measurement/measurement.hpp"
#include "estimators/navigation/innovation_tally.hpp"
#include "estimators/pipeline/listener.hpp"

namespace drydock::pipeline {

struct PeerAccount;

/// What an estimator did with a measurement. The best outcome comes first.
enum class Outcome : std::uint8_t {
  accepted,  ///< used in the order of valid_at
  delayed,   ///< older than the estimator's time, but used on the present state
  late,      ///< too old to be used
  refused,   ///< not finite, or too large for a vehicle
  unused,    ///< not from this estimator's device, or without the value that it needs
  left_out   ///< its device is not sound; the pipeline says so, no estimator
};

enum class EstimatorState : std::uint8_t {
  waiting_for_imu,
  waiting_for_speed,
  waiting_for_satellites,
  running,
  lost,  ///< a new start is needed: the IMU was silent for too long, or another program failed
  waiting_for_answers  ///< of an estimator in another program
};

constexpr std::string_view to_string(EstimatorState state) {
  constexpr std::array<std::string_view, 6> names{
      "waiting for imu",    "waiting for speed", "waiting for satellites", "running", "lost",
      "waiting for answers"};
  return names[static_cast<std::size_t>(state)];
}

struct EstimatorStatus {
  EstimatorState state = EstimatorState::waiting_for_imu;
  std::uint64_t estimates = 0;
  /// After a gap in the samples or a clock set back; of mixing, also behind a fault of its IMU.
  std::uint64_t restarts = 0;
  std::uint64_t divergences = 0;       ///< starts because the innovations contradicted for too long
  std::uint64_t wild = 0;              ///< IMU samples that no vehicle can cause, not used
  std::uint64_t steps = 0;             ///< steps of the IMU that no vehicle can make
  std::uint64_t valid_estimates = 0;   ///< of `estimates`
  std::uint64_t missing = 0;           ///< that did not come, while it had nothing to go on
  bool valid = false;                  ///< the last estimate; false before the first
  measurement::Stamp last_estimate{};  ///< valid_at
  measurement::Stamp last_speed{};     ///< valid_at
  std::uint64_t rejected = 0;          ///< values outside the estimator's innovation gate
  navigation::InnovationTally taken;   ///< sensor values inside the gate; none without innovations
  std::uint64_t bridged = 0;           ///< gaps of speed or heading, passed over
  double bridged_s = 0, longest_bridged_s = 0;  ///< all of them, the longest
  std::chrono::nanoseconds longest_silence{0};  ///< between two estimates, beyond the IMU's
  std::optional<measurement::Stamp> lost_at;    ///< valid_at of the last used IMU sample
};

/// The share of valid ones among the estimates from `before` to `now`; those that did not come are
/// not valid. Empty: there was none to come.
inline std::optional<double> valid_share(const EstimatorStatus& before,
                                         const EstimatorStatus& now) {
  const auto all = now.estimates + now.missing - before.estimates - before.missing;
  if (all == 0) return {};
  return static_cast<double>(now.valid_estimates - before.valid_estimates) /
         static_cast<double>(all);
}

/// One estimator in the pipeline. Measurements arrive in the order of valid_at as far as the
/// reorder window allows. The estimator decides on measurements that are older than its own time.
class Estimator {
 public:
  virtual ~Estimator() = default;
  virtual Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) = 0;
  virtual Outcome take(const measurement::WaterSpeed&, EstimateListener&) {
    return Outcome::unused;
  }
  virtual Outcome take(const measurement::DepthSample&, EstimateListener&) {
    return Outcome::unused;
  }
  virtual Outcome take(const measurement::BottomVelocity&, EstimateListener&) {
    return Outcome::unused;
  }
  virtual Outcome take(const measurement::ActuatorState&, EstimateListener&) {
    return Outcome::unused;
  }
  virtual Outcome take(const measurement::AttitudeSample&, EstimateListener&) {
    return Outcome::unused;
  }
  virtual Outcome take(const measurement::GnssFix&, EstimateListener&) { return Outcome::unused; }
  virtual Outcome take(const measurement::GnssSatellites&, EstimateListener&) {
    return Outcome::unused;
  }
  /// A finding says that the values of a device in use mislead, or no more: the estimator may go on
  /// with them, but its estimates are not valid.
  virtual void doubt(std::uint16_t /*device*/, bool /*doubted*/) {}
  /// All measurements older than `now` have come.
  virtual void advance(measurement::Stamp /*now*/, EstimateListener&) {}
  /// The run ends.
  virtual void finish(EstimateListener&) {}
  virtual const EstimatorStatus& status() const = 0;
  /// How the talk with another program goes; null: the estimator is one of this program.
  virtual const PeerAccount* peer() const { return nullptr; }
};

}  // namespace drydock::pipeline
