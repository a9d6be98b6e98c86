#include "estimators/roll/peak_filter.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::roll {

void PeakFilter::predict(double rate_radps, double dt) {
  time_s_ += dt;
  gyro_rad_ += rate_radps * dt;
  if (!running_) return;
  Eigen::Matrix2d transition;
  transition << 1, -dt, 0, 1;
  x_(0) += (rate_radps - x_(1)) * dt;
  p_ = (transition * p_ * transition.transpose()).eval();
  p_(0, 0) += options_.roll_noise * options_.roll_noise * dt;
  if (options_.with_bias) p_(1, 1) += options_.bias_noise * options_.bias_noise * dt;
}

void PeakFilter::update(const Epoch& epoch) {
  peaks_.clear();
  slots_.begin_epoch();
  for (const Signal& signal : epoch.signals) {
    const auto place = slots_.place_of(signal.satellite);
    if (!place) continue;
    PeakFinder& finder = finders_[place->slot];
    if (place->fresh) finder.clear();
    const SightLine line(signal.toward_ned, epoch.path, options_.antenna.boresight_body);
    auto peak = finder.add(options_.peak, signal.power.value_or(0), time_s_ - epoch.age_s,
                           gyro_rad_ - epoch.turned_rad, line.strongest_roll());
    if (!peak) continue;
    peak->satellite = signal.satellite;
    peaks_.push_back(*peak);
    use(*peak);
  }
}

void PeakFilter::use(const Peak& peak) {
  const double age = time_s_ - peak.time_s, turned = gyro_rad_ - peak.gyro_rad;
  const double variance = options_.peak_sigma_rad * options_.peak_sigma_rad;
  if (!running_) {
    running_ = true;
    x_ << peak.roll_rad + turned, 0;
    p_.setZero();
    p_(0, 0) = variance;
    if (options_.with_bias) p_(1, 1) = options_.bias_sigma_radps * options_.bias_sigma_radps;
    return;
  }
  // The peak was `age` seconds ago. The roll at that time was x_0 - (turned - x_1 age).
  const Eigen::RowVector2d h{1, age};
  const double residual = frame::wrap_pi(peak.roll_rad - (h * x_ - turned));
  const Eigen::Vector2d gain = p_ * h.transpose() / (h * p_ * h.transpose() + variance);
  x_ += gain * residual;
  p_ = ((Eigen::Matrix2d::Identity() - gain * h) * p_).eval();
  p_(0, 1) = p_(1, 0) = 0.5 * (p_(0, 1) + p_(1, 0));
}

double PeakFilter::roll() const { return frame::wrap_pi(x_(0)); }

}  // namespace drydock::roll
