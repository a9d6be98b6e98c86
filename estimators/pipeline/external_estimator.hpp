#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/external_options.hpp"

namespace drydock::pipeline {

/// Collects the measurements of each step and hands them to the other program.
class ExternalEstimator final : public Estimator {
 public:
  ExternalEstimator(Seat seat, const ExternalOptions& options);

  Outcome take(const measurement::ImuSample& m, EstimateListener& l) override { return keep(m, l); }
  Outcome take(const measurement::WaterSpeed& m, EstimateListener& l) override {
    return keep(m, l);
  }
  Outcome take(const measurement::DepthSample& m, EstimateListener& l) override {
    return keep(m, l);
  }
  Outcome take(const measurement::BottomVelocity& m, EstimateListener& l) override {
    return keep(m, l);
  }
  Outcome take(const measurement::ActuatorState& m, EstimateListener& l) override {
    return keep(m, l);
  }
  Outcome take(const measurement::AttitudeSample& m, EstimateListener& l) override {
    return keep(m, l);
  }
  Outcome take(const measurement::GnssFix& m, EstimateListener& l) override { return keep(m, l); }
  Outcome take(const measurement::GnssSatellites& m, EstimateListener& l) override {
    return keep(m, l);
  }
  void advance(Stamp now, EstimateListener& listener) override;
  void finish(EstimateListener& listener) override;
  const EstimatorStatus& status() const override { return status_; }
  const PeerAccount* peer() const override { return peer_ ? &peer_->account() : nullptr; }

 private:
  template <class Measurement>
  Outcome keep(const Measurement& measurement, EstimateListener& listener);
  void begin(Stamp at);
  void close_step(Stamp at, EstimateListener& listener);
  void hand_over(Stamp now);
  void hear(EstimateListener& listener);
  void tell(EstimateListener& listener);
  void tell(OutsideEstimate& estimate, EstimateListener& listener);
  bool is_in_time(const OutsideEstimate& estimate) const;

  std::uint16_t index_;
  std::chrono::nanoseconds step_;
  std::unique_ptr<Peer> peer_;  ///< null: nobody is asked
  std::vector<Sample> samples_;
  std::vector<OutsideEstimate> answers_;
  std::optional<Stamp> step_end_;  ///< empty before the first measurement
  Stamp newest_{};                 ///< valid_at of the newest measurement handed over
  Stamp oldest_allowed_{};         ///< of the next estimate
  std::uint64_t steps_ = 0;
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline
