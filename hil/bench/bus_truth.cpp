#include "hil/bench/bus_truth.hpp"

#include "estimators/host/bus_estimates.hpp"
#include "hil/bench/truth_estimate.hpp"

namespace drydock::bench {

namespace {

constexpr std::chrono::milliseconds bus_truth_interval{10};
constexpr std::size_t only_one = 0;

}  // namespace

BusTruth::BusTruth(const bus::Participant& participant, const motion::Trajectory& truth)
    : truth_(truth), to_(participant, {}, {"truth"}, {"truth"}), clock_(participant) {}

void BusTruth::on_measurement(const measurement::Measurement& measurement) {
  const auto* imu = std::get_if<measurement::ImuSample>(&measurement);
  if (imu == nullptr) return;
  const auto at = imu->origin.valid_at;
  if (at - last_ < bus_truth_interval && at >= last_) return;
  last_ = at;
  const auto truth = as_estimate(truth_.at(at));
  if (!origin_) origin_ = truth.position;
  const auto told = host::bus_estimate(truth, *origin_);
  to_.publish(told.attitude, only_one);
  to_.publish(*told.navigation, only_one);
  clock_.write(imu->origin.received_at);
}

}  // namespace drydock::bench
