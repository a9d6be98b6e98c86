#include "estimators/roll/all_satellites.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::roll {
namespace {

/// A hypothesis is dropped if its log likelihood is this much below the best: odds of 1 to 3
/// million.
constexpr double hopeless = 15;
constexpr double same_rad = 3 * std::numbers::pi / 180;

double roll_of(const Hypothesis& h) { return h.state()(0); }

}  // namespace

AllSatellites::AllSatellites(const AllSatellitesOptions& options) : options_(options) {
  options_.hypotheses = std::clamp(options.hypotheses, 1, static_cast<int>(hypotheses_.capacity()));
}

void AllSatellites::start() {
  const double spacing = 2 * std::numbers::pi / options_.hypotheses;
  for (int i = 0; i < options_.hypotheses; ++i)
    hypotheses_.emplace_back(i * spacing, spacing / 2, options_);
}

void AllSatellites::restart() {
  hypotheses_.clear();
  watch_.clear();
}

void AllSatellites::loosen() {
  for (Hypothesis& h : hypotheses_) h.loosen(watch_.error_rad(), options_.bias_sigma_radps);
  watch_.clear();
}

void AllSatellites::loosen_bias(double sigma_radps) {
  for (Hypothesis& h : hypotheses_) h.loosen(0, sigma_radps);
}

void AllSatellites::predict(double rate_radps, double dt) {
  since_epoch_s_ += dt;
  for (Hypothesis& h : hypotheses_) h.predict(options_, rate_radps, dt);
}

void AllSatellites::update(const Epoch& epoch) {
  if (!running()) start();
  slots_.begin_epoch();
  for (Hypothesis& h : hypotheses_) h.evidence = {};
  for (const Signal& signal : epoch.signals) {
    const auto place = slots_.place_of(signal.satellite);
    if (!place) continue;
    const SightLine line(signal.toward_ned, epoch.path, options_.antenna.boresight_body);
    for (Hypothesis& h : hypotheses_) {
      if (place->fresh) h.forget_gain(place->slot, options_.satellite_gain_sigma);
      const bool used = h.update(options_, signal, line, epoch, place->slot);
      if (!used && &h == &hypotheses_.front()) ++rejected_;
    }
  }
  weigh();
  if (hypotheses_.size() == 1) {
    watch_.add(best().evidence, since_epoch_s_);
  } else {
    watch_.clear();
  }
  since_epoch_s_ = 0;
}

void AllSatellites::weigh() {
  const auto by_likelihood = [](const Hypothesis& a, const Hypothesis& b) {
    return a.log_likelihood > b.log_likelihood;
  };
  std::ranges::sort(hypotheses_, by_likelihood);
  const double best = hypotheses_.front().log_likelihood;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    Hypothesis& h = hypotheses_[i];
    h.log_likelihood -= best;
    if (h.log_likelihood < -hopeless) break;
    const auto end = hypotheses_.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto met = std::find_if(hypotheses_.begin(), end, [&](const Hypothesis& other) {
      return std::abs(frame::wrap_pi(roll_of(h) - roll_of(other))) < same_rad;
    });
    if (met != end) {
      met->log_likelihood += std::log1p(std::exp(h.log_likelihood - met->log_likelihood));
    } else {
      if (kept != i) hypotheses_[kept] = h;
      ++kept;
    }
  }
  hypotheses_.resize(kept);
}

double AllSatellites::roll() const { return frame::wrap_pi(roll_of(best())); }

double AllSatellites::roll_variance() const {
  double weights = 0, sum = 0;
  for (const Hypothesis& h : hypotheses_) {
    const double weight = std::exp(h.log_likelihood - best().log_likelihood);
    const double apart = frame::wrap_pi(roll_of(h) - roll_of(best()));
    weights += weight;
    sum += weight * (h.covariance()(0, 0) + apart * apart);
  }
  return sum / weights;
}

}  // namespace drydock::roll
