#include "hil/study/roll/roll_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/sky/antenna.hpp"

namespace drydock::study {
namespace {

constexpr double paper_power = 664;  // in eq. (23), at boresight
constexpr double epoch_s = roll_gyro_per_epoch / roll_gyro_hz;

/// The method's name for a legend. An underscore would make the next letter a subscript.
std::string label_of(const RollMethod& method) {
  std::string label(method.name);
  std::ranges::replace(label, '_', ' ');
  return label;
}

double decibels(double power) { return 10 * std::log10(power); }

/// Fig. 4.
report::Figure pattern() {
  report::Figure figure{"Fig. 4: gain pattern of the antenna",
                        "elevation above the antenna's horizon [deg]",
                        "[dB]",
                        {}};
  report::Curve curve{"P / P at boresight", {}, {}};
  for (int elevation = -90; elevation <= 90; ++elevation) {
    curve.x.push_back(elevation);
    curve.y.push_back(decibels(sky::antenna_power(elevation * units::degree)));
  }
  figure.curves = {curve};
  return figure;
}

/// Fig. 5 and 6: one satellite at the zenith, while the antenna rolls at a steady rate.
report::Figure sampled(int number, double roll_hz, bool in_decibels) {
  report::Figure figure{
      fmt::format("Fig. {}: sampled signal power, roll rate {} Hz", number, roll_hz),
      "time [s]",
      in_decibels ? "P [dB]" : "P",
      {}};
  for (const double pitch_deg : {0.0, 45.0}) {
    const roll::SightLine line({0, 0, -1}, {0, pitch_deg * units::degree}, {0, 0, 1});
    const auto power = [&](double t) {
      const double sine = line.sin_elevation(2 * std::numbers::pi * roll_hz * t);
      const double p = paper_power * sky::antenna_power(std::asin(std::clamp(sine, -1.0, 1.0)));
      return in_decibels ? decibels(p) : p;
    };
    const double span_s = 2 / roll_hz;
    report::Curve smooth{fmt::format("pitch {} deg", pitch_deg), {}, {}};
    for (int i = 0; i <= 400; ++i) {
      smooth.x.push_back(span_s * i / 400);
      smooth.y.push_back(power(smooth.x.back()));
    }
    report::Curve epochs{fmt::format("at 10 Hz, pitch {} deg", pitch_deg), {}, {}, false, true};
    for (int epoch = 0; epoch * epoch_s < span_s; ++epoch) {
      const double t = epoch * epoch_s;
      epochs.x.push_back(t);
      epochs.y.push_back(power(t));
    }
    figure.curves.push_back(smooth);
    figure.curves.push_back(epochs);
  }
  return figure;
}

/// Collects the data of Fig. 7 (one satellite) and Fig. 8.
class Gatherer final : public RollObserver {
 public:
  Gatherer(const RollFlight& flight, std::uint16_t shown) : flight_(flight), shown_(shown) {}

  void on_epoch(double t, std::span<const roll::Signal> signals, const roll::PeakFilter& paper,
                double true_roll) override {
    const roll::SightLine line(signals[shown_].toward_ned, flight_.path(t), {0, 0, 1});
    const double sine = std::clamp(line.sin_elevation(true_roll), -1.0, 1.0);
    add(elevation, t, std::asin(sine) / units::degree);
    add(power, t, paper_power * signals[shown_].power.value_or(0));
    add(expected, t, paper_power * sky::antenna_power(std::asin(sine)));
    add(roll, t, frame::wrap_pi(true_roll) / units::degree);
    for (const auto& peak : paper.peaks()) {
      add(measured, peak.time_s, peak.roll_rad / units::degree);
      const double truth = flight_.true_roll(peak.time_s);
      add(measured_error, peak.time_s, frame::wrap_pi(peak.roll_rad - truth) / units::degree);
      if (peak.satellite == shown_) add(found, peak.time_s, paper_power);
    }
  }

  report::Curve elevation{"elevation", {}, {}}, expected{"without noise", {}, {}},
      power{"received", {}, {}, false, true}, found{"peak found", {}, {}, false, true},
      roll{"true roll", {}, {}}, measured{"from one peak", {}, {}, false, true},
      measured_error{"from one peak", {}, {}, false, true};

 private:
  static void add(report::Curve& curve, double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  }
  const RollFlight& flight_;
  std::uint16_t shown_;
};

/// The first `seconds` of a curve; a longer curve would not be readable.
report::Curve beginning(report::Curve curve, double seconds) {
  std::size_t n = 0;
  while (n < curve.x.size() && curve.x[n] <= seconds) ++n;
  curve.x.resize(n);
  curve.y.resize(n);
  return curve;
}

report::Curve error_curve(std::size_t method, const RollOutcome& outcome) {
  report::Curve curve{label_of(roll_methods[method]), {}, {}};
  const auto& errors = outcome.errors[method].at_epochs;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (std::isnan(errors[i])) continue;
    curve.x.push_back(epoch_s * static_cast<double>(i + 1));
    curve.y.push_back(errors[i]);
  }
  return curve;
}

}  // namespace

std::vector<report::Figure> roll_figures(const RollCase& the_case, const RollSky& sky,
                                         std::uint64_t seed) {
  constexpr std::uint16_t shown = 3;  // index of the satellite, highest first
  constexpr double shown_s = 40;
  const RollFlight flight(the_case, sky, seed, 0);
  Gatherer seen(flight, shown);
  const auto outcome = roll_run(the_case, sky, seed, 0, &seen);

  report::Figure signal{"Fig. 7: signal power of one satellite and its peaks, 0.25 Hz",
                        "time [s]",
                        "P",
                        {beginning(seen.expected, shown_s), beginning(seen.power, shown_s),
                         beginning(seen.found, shown_s)}};
  report::Figure errors{
      "Fig. 9: roll error of the filters",
      "time [s]",
      "deg",
      {error_curve(0, outcome), error_curve(2, outcome), error_curve(3, outcome)}};
  errors.y_limit = 20;
  return {pattern(),
          sampled(5, 2, false),
          sampled(5, 2, true),
          sampled(6, 0.25, false),
          sampled(6, 0.25, true),
          {"Fig. 7: elevation of one satellite above the antenna's horizon",
           "time [s]",
           "deg",
           {beginning(seen.elevation, shown_s)}},
          signal,
          {"Fig. 8: roll angle by single peaks",
           "time [s]",
           "deg",
           {beginning(seen.roll, shown_s), beginning(seen.measured, shown_s)}},
          {"Fig. 8: its error", "time [s]", "deg", {seen.measured_error}},
          errors};
}

void RollEnsemble::add(const RollOutcome& outcome) {
  if (squares_.empty())
    squares_.assign(roll_methods.size() + 1, std::vector<double>(outcome.bound.size()));
  ++runs_;
  for (std::size_t i = 0; i < outcome.bound.size(); ++i) {
    for (std::size_t m = 0; m < roll_methods.size(); ++m)
      squares_[m][i] += std::pow(outcome.errors[m].at_epochs[i], 2);  // NaN until every run has an
                                                                      // estimate
    squares_.back()[i] += outcome.bound[i] / (units::degree * units::degree);
  }
}

report::Figure RollEnsemble::figure() const {
  report::Figure figure{"Roll error over the runs, ideal signals", "time [s]", "RMS [deg]", {}};
  for (std::size_t m = 0; m < squares_.size(); ++m) {
    report::Curve curve{
        m < roll_methods.size() ? label_of(roll_methods[m]) : "Cramer-Rao bound", {}, {}};
    for (std::size_t i = 0; i < squares_[m].size(); ++i) {
      const double rms = std::sqrt(squares_[m][i] / runs_);
      if (!(rms <= 12)) continue;
      curve.x.push_back(epoch_s * static_cast<double>(i + 1));
      curve.y.push_back(rms);
    }
    figure.curves.push_back(curve);
  }
  return figure;
}

}  // namespace drydock::study
