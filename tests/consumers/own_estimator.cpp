// An estimator of one's own in the pipeline: the direction of gravity, for a vehicle at rest.
#include <cmath>
#include <drydock/estimators/pipeline/pipeline.hpp>
#include <iostream>

using namespace drydock;

class Plumb : public pipeline::Estimator {
 public:
  pipeline::Outcome take(const measurement::ImuSample& sample,
                         pipeline::EstimateListener& listener) override {
    mean_ += (sample.specific_force - mean_) / static_cast<double>(++status_.estimates);
    pipeline::AttitudeEstimate estimate{.valid_at = sample.origin.valid_at};
    estimate.roll_rad = std::atan2(-mean_.y(), -mean_.z());
    estimate.pitch_rad = std::atan2(mean_.x(), std::hypot(mean_.y(), mean_.z()));
    listener.on_attitude(estimate);
    return pipeline::Outcome::accepted;
  }
  const pipeline::EstimatorStatus& status() const override { return status_; }

 private:
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  pipeline::EstimatorStatus status_;
};

struct Last : pipeline::EstimateListener {
  pipeline::AttitudeEstimate estimate;
  void on_attitude(const pipeline::AttitudeEstimate& one) override { estimate = one; }
};

int main() {
  Last last;
  std::vector<std::unique_ptr<pipeline::Estimator>> estimators;
  estimators.push_back(std::make_unique<Plumb>());
  pipeline::Pipeline pipeline({}, last, std::move(estimators));
  for (int i = 100; i > 0; --i) {  // newest first within the reorder window of 0.2 s
    measurement::ImuSample sample;
    sample.origin.valid_at = measurement::stamp_from_ns(1'000'000 * i);
    // 10 deg of roll, and a swing of 0.5 m/s2 along y whose mean is zero.
    sample.specific_force = {0, -9.81 * std::sin(10 * M_PI / 180) + (i % 2 ? 0.5 : -0.5),
                             -9.81 * std::cos(10 * M_PI / 180)};
    pipeline.receive(sample);
  }
  pipeline.flush();
  std::cout << last.estimate.roll_rad * 180 / M_PI << " deg at "
            << last.estimate.valid_at.time_since_epoch().count() << " ns\n";
}
