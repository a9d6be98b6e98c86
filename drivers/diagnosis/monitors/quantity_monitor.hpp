#pragma once

#include <array>
#include <limits>
#include <optional>

#include "drivers/diagnosis/monitors/event_test.hpp"
#include "drivers/diagnosis/monitors/quantity.hpp"
#include "drivers/diagnosis/monitors/resolution.hpp"
#include "drivers/diagnosis/monitors/spread.hpp"

namespace drydock::diagnosis {

/// Watches one number of a sensor by its second differences, which no slow motion moves: single
/// wild samples, noise that rose, steps. What is usual is the scatter in the sensor's own first
/// time, at least what a usual motion bends within a period.
class QuantityMonitor {
 public:
  static constexpr std::chrono::seconds learning{45};
  static constexpr std::size_t fewest = 30;
  static constexpr double noise_threshold = 22;

  /// What a new sample showed about the one before it.
  struct News {
    double wild = 0;    ///< this far off both neighbours, which agree; 0: it fits
    double pulse = 0;   ///< the same beyond the noise only
    double jump = 0;    ///< a step that no motion makes and that stayed; 0: none
    double most = 0;    ///< the largest step that a motion makes in this time; 0: no jump
    double coarse = 0;  ///< the step in which it comes now, coarser than it was; 0: as usual
    bool noisy = false;
  };

  /// `grade`: 1 sigma of the sensor's white noise, as its data sheet says; 0: not known.
  explicit QuantityMonitor(Quantity quantity = Quantity::force_x, double grade = 0)
      : quantity_(quantity), grade_(grade) {}

  News add(double value, Stamp at);
  /// The next sample has none before it.
  void interrupt() { samples_ = 0; }

  Quantity quantity() const { return quantity_; }
  bool known() const { return known_; }
  double sigma() const { return sigma_; }  ///< usual deviation of second differences
  /// The largest change of sound samples from one to the next, at the present slope.
  double usual_change() const;
  bool noise_shows() const { return noise_shows_; }  ///< sound samples go up and down
  const EventTest& noise() const { return noise_; }
  const Resolution& resolution() const { return resolution_; }

 private:
  double minus(double a, double b) const;
  bool is_pause(double period_s);
  void learn(double bend, Stamp at, double period_s);
  double half_step() const;
  double scatter_of_bends();
  void refine(double bend);
  void set_sigma();
  void hold_to_grade();
  News judge(double period_s, Stamp at);
  void judge_noise(double bend, Stamp at);

  Quantity quantity_;
  double grade_ = 0;
  bool known_ = false, noise_shows_ = false;
  double sigma_ = 0;    ///< at least that of a usual motion
  double scatter_ = 0;  ///< as it was in the first time
  double rate_ = 0;     ///< the mean first derivative, of a vehicle that is fast itself
  double usual_period_s_ = 0;
  std::array<double, 2> last_bends_{};
  double smallest_bend_ = std::numeric_limits<double>::infinity();
  Spread<128> bends_, periods_;
  unsigned turns_ = 0, moves_ = 0;  ///< changes of direction among changes
  std::optional<Stamp> first_;
  std::array<double, 4> last_{};    ///< samples, the latest first
  std::array<double, 3> took_s_{};  ///< from the sample before to each of them
  Stamp last_at_{};
  unsigned samples_ = 0;  ///< of last_
  EventTest noise_{0.02, 0.5, noise_threshold};
  Resolution resolution_;
  double trembling_ = 0;  ///< deviation of second differences that go to and fro
};

}  // namespace drydock::diagnosis
