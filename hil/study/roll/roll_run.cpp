#include "hil/study/roll/roll_run.hpp"

#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/study/roll/roll_bound.hpp"
#include "hil/study/roll/roll_witness.hpp"

namespace drydock::study {
namespace {

constexpr double converged_deg = 5, converged_for_s = 2;
constexpr int kept_each = 7;  // no common factor with an epoch, so that errors of every age are
                              // kept

/// Follows the error of one method.
class Errors {
 public:
  void add(double t, double error_deg, double variance_rad2) {
    if (std::abs(error_deg) >= converged_deg) within_since_ = t;
    if (!converged_ && t - within_since_ >= converged_for_s) {
      converged_ = true;
      result_.convergence_s = within_since_;
    }
    if (t <= roll_settled_s) return;
    squares_ += error_deg * error_deg;
    nees_ += error_deg * error_deg /
             (variance_rad2 * units::degrees_per_radian * units::degrees_per_radian);
    if (count_++ % kept_each == 0)
      result_.absolute.push_back(static_cast<float>(std::abs(error_deg)));
  }
  void none(double t) { within_since_ = t; }
  void at_epoch(double error_deg) { result_.at_epochs.push_back(static_cast<float>(error_deg)); }

  RollErrors result() && {
    result_.rms = std::sqrt(squares_ / count_);
    result_.nees = nees_ / count_;
    if (!converged_) result_.convergence_s = roll_run_s;
    return std::move(result_);
  }

 private:
  RollErrors result_;
  double within_since_ = 0, squares_ = 0, nees_ = 0;
  int count_ = 0;
  bool converged_ = false;
};

/// A filter, the bias of its gyro, and its error.
template <class Filter>
class Follower {
 public:
  Follower(const Filter& filter, const RollMethod& method)
      : filter_(filter), bias_(method.gyro_bias_degps / units::degrees_per_radian) {}

  void predict(double rate) { filter_.predict(rate + bias_, 1 / roll_gyro_hz); }
  void judge(double t, double true_roll, bool epoch) {
    const bool known = filter_.running();
    const double error =
        known ? frame::wrap_pi(filter_.roll() - true_roll) * units::degrees_per_radian
              : std::numeric_limits<double>::quiet_NaN();
    if (known) {
      errors_.add(t, error, filter_.roll_variance());
    } else {
      errors_.none(t);
    }
    if (epoch) errors_.at_epoch(error);
  }
  Filter& filter() { return filter_; }
  RollErrors errors() { return std::move(errors_).result(); }

 private:
  Filter filter_;
  double bias_;
  Errors errors_;
};

void keep_raw(std::vector<float>& raw, const roll::PeakFilter& filter, const RollFlight& flight) {
  for (const auto& peak : filter.peaks())
    raw.push_back(
        static_cast<float>(std::abs(frame::wrap_pi(peak.roll_rad - flight.true_roll(peak.time_s))) *
                           units::degrees_per_radian));
}

}  // namespace

roll::PeakFilterOptions peak_options(bool with_bias) {
  roll::PeakFilterOptions options;
  options.with_bias = with_bias;
  // The scalar filter's w must also cover the gyro bias. Here the bias is a state.
  if (with_bias) options.roll_noise = 0.5 / units::degrees_per_radian;
  return options;
}

roll::AllSatellitesOptions all_satellites_options(const RollCase& the_case) {
  roll::AllSatellitesOptions options;
  options.antenna.noise = the_case.power_noise;
  options.gyro_noise =
      the_case.gyro_white_degps / units::degrees_per_radian / std::sqrt(roll_gyro_hz);
  if (the_case.wire) {
    options.antenna.resolution_db = 1;
    options.antenna.tracking_limit = roll_tracking_limit;
  }
  return options;
}

RollOutcome roll_run(const RollCase& the_case, const RollSky& sky, std::uint64_t seed,
                     std::size_t run, RollObserver* observer) {
  RollFlight flight(the_case, sky, seed, run);
  std::array peaks{Follower{roll::PeakFilter(peak_options(false)), roll_methods[0]},
                   Follower{roll::PeakFilter(peak_options(false)), roll_methods[1]},
                   Follower{roll::PeakFilter(peak_options(true)), roll_methods[2]}};
  const auto options = all_satellites_options(the_case);
  Follower ours{roll::AllSatellites(options), roll_methods[3]};
  RollWitness witness(the_case, flight, options,
                      roll_methods[3].gyro_bias_degps / units::degrees_per_radian);
  double witness_squares = 0, witnessed = 0;
  // The paper's filters get the azimuth of a reference point; ours gets the course.
  const double azimuth =
      roll::azimuth_of_point(sky.place.latitude_rad, sky.place.longitude_rad,
                             flight.reference().latitude_rad, flight.reference().longitude_rad);

  RollOutcome outcome;
  const auto samples = static_cast<int>(roll_run_s * roll_gyro_hz);
  for (int k = 1; k <= samples; ++k) {
    const double t = k / roll_gyro_hz, rate = flight.gyro(t), truth = flight.true_roll(t);
    for (auto& follower : peaks) follower.predict(rate);
    ours.predict(rate);
    const double turned = truth - flight.true_roll(t - 1 / roll_gyro_hz);
    witness.predict(rate - turned * roll_gyro_hz, 1 / roll_gyro_hz);
    const bool epoch = k % roll_gyro_per_epoch == 0;
    if (epoch) {
      const auto signals = flight.signals(t);
      const auto path = flight.path(t);
      for (auto& follower : peaks)
        follower.filter().update({.signals = signals, .path = {azimuth, path.pitch_rad}});
      ours.filter().update({.signals = signals, .path = path});
      witness.update(t, signals);
      keep_raw(outcome.raw, peaks[0].filter(), flight);
      if (observer) observer->on_epoch(t, signals, peaks[0].filter(), truth);
    }
    for (auto& follower : peaks) follower.judge(t, truth, epoch);
    ours.judge(t, truth, epoch);
    if (t > roll_settled_s) {
      witness_squares += std::pow(witness.roll_error() * units::degrees_per_radian, 2);
      ++witnessed;
    }
  }
  outcome.witness_rms = std::sqrt(witness_squares / witnessed);
  for (std::size_t i = 0; i < peaks.size(); ++i) outcome.errors[i] = peaks[i].errors();
  outcome.errors.back() = ours.errors();
  outcome.bound = roll_bound(the_case, flight, options.bias_sigma_radps, options.bias_noise);
  return outcome;
}

}  // namespace drydock::study
