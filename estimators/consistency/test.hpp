#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "drivers/diagnosis/sign.hpp"
#include "estimators/consistency/cusum.hpp"
#include "estimators/consistency/first_residuals.hpp"
#include "estimators/consistency/freeze.hpp"
#include "estimators/consistency/maybe_late.hpp"
#include "estimators/consistency/passing_error.hpp"
#include "estimators/consistency/shape.hpp"

namespace drydock::consistency {

/// What is known of a residual beforehand.
struct TestFacts {
  double floor = 0;   ///< 1 sigma of model errors that no minute of learning shows
  double wander = 0;  ///< per second: the offset of a healthy residual moves at most so fast
  /// The same of the sum that it is compared with, while it is accused; 0: of no sum.
  double others_wander = 0;
  double trend = 0;     ///< per second: a healthy offset may grow steadily, at most so fast
  double late_s = 0.1;  ///< 1 sigma of the sensors' unknown latency
  /// A residual that grows faster than this (per second) is the sum of a constant error, not a slow
  /// drift. 0 for a residual that is a sum, infinity for a plain difference.
  double sum_above = std::numeric_limits<double>::infinity();
  /// The device, or one that it is compared with, may be late: then a residual that differs while
  /// the quantity changes has no word yet.
  bool may_be_late = false;
  bool scales = false;  ///< a wrong factor is possible: the quantity has a zero
  bool holds = false;   ///< what is not known now ends no alarm
  /// What is not known now errs by the same for some seconds and then passes: an offset that was
  /// learned meanwhile is not known better.
  bool passes = false;
  /// What its kin deviate by as well is an error that they share, and no fault of a device.
  bool excused_by_kin = false;
  /// It repeats one value while nothing happens: it has stopped if the others move from it.
  bool is_often_equal = false;
  std::string_view quantity, unit;
  double unit_si = 1;  ///< one unit in SI
};

/// What a test takes at one time.
struct Residual {
  double value = 0;
  double rate = 0;        ///< derivative of the measured quantity
  double quantity = 0;    ///< its value
  double sigma = 0;       ///< of further errors at this time
  bool shapes = false;    ///< rate and quantity do not come from the device itself
  bool pair = false;      ///< of two witnesses that accuse each other
  bool at_fault = false;  ///< its device is wrong now: nothing is learned from it
};

/// One residual: a difference that is constant but for noise while all is well. It learns offset
/// and noise in its first samples, follows the offset slowly and tests it with a CUSUM.
class Test {
 public:
  explicit Test(const TestFacts& facts) : facts_(facts) {}

  void take(const Residual& residual, Stamp at);
  /// The offset begins anew, as after an outage of a sum.
  void restart();
  /// What it was compared with has been wrong since then: an alarm that rose meanwhile is none of
  /// its own. A sum begins anew.
  void acquit(Stamp since);
  /// Its device was at fault since then and is sound again: an alarm was of that fault, and what
  /// was learned since is forgotten. A sum and what is compared with one begin anew, and so does
  /// what had learned nothing before.
  void forget(Stamp since);
  /// The residuals to come are larger by so much, for no fault of the device.
  void shift(double by) {
    for (Learned* one : {&learned_, &kept_[0], &kept_[1]}) one->offset += by;
  }

  bool learned() const { return samples_ >= learning_samples; }
  bool fired() const { return fired_; }
  /// 0: quiet, 1: fired.
  double suspicion() const { return std::min(1.0, cusum_.value() / design.limit); }
  double offset() const { return learned_.offset; }
  double sigma() const { return sigma_; }
  /// 1 sigma of the residual in usual times, as far as it was learned.
  double spread() const;
  Stamp since() const { return since_; }
  Stamp last() const { return last_; }             ///< when it was tested last
  double deviation() const { return deviation_; }  ///< of the last residual from its offset
  /// What speaks most for the alarm: the deviation of most sigmas since it began to rise, and the
  /// least deviation that makes it rise.
  struct Evidence {
    double deviation = 0, least = 0;
  };
  Evidence evidence() const { return {peak_, design.reference * peak_sigma_}; }
  /// What the history of the residual says about the device.
  diagnosis::Sign sign(const Freeze* own) const;
  /// Whether it is late or off, only the end of the manoeuvre tells.
  bool is_open(const Freeze* own) const;
  Shape shape() const { return shape_.best(); }
  /// How much of the squared deviation the likeliest shape explains, 0 to 1.
  double fit() const { return shape_.fit(); }
  const TestFacts& facts() const { return facts_; }

  /// At five samples a second the mean time between false alarms of one test is 432 years.
  static constexpr CusumDesign design{};
  static constexpr int learning_samples = 50;

 private:
  /// What it knows of the residual in usual times.
  struct Learned {
    double offset = 0, trend = 0, mean_square = 0;
    PassingError passing;
    Stamp at{};  ///< when it was kept; none: never
  };

  void learn(const Residual& residual, double dt);
  void follow(const Residual& residual, double dt);
  bool drifts() const;
  void keep(Stamp at);
  void end_fault(Stamp at);
  bool is_over(double steady_s) const;
  bool was_learned_in_fault(double steady_s) const;
  const Learned* kept_before(Stamp since) const;
  bool is_where_it_was(const Learned& before) const;
  bool have_others_followed() const;
  bool is_blind(const Residual& residual) const;
  bool has_stopped(const Freeze* own) const;
  enum class Late : std::uint8_t { no, open, yes };
  Late late() const;
  void test(const Residual& residual, Stamp at);
  double sigma_of(const Residual& residual, double spread) const;

  TestFacts facts_;
  int samples_ = 0, fired_samples_ = 0;
  Learned learned_;
  std::array<Learned, 2> kept_{};  ///< as it was some time ago, and some time before
  double steady_ = 0, noise_square_ = 0;
  double deviation_ = 0, sigma_ = 0;
  double peak_ = 0, peak_sigma_ = 1, moved_ = 0;
  double usual_rate_ = 0, usual_quantity_ = 0;
  Stamp last_{}, since_{}, steady_since_{}, learned_at_{}, young_at_{};
  bool fired_ = false, fired_up_ = false, learns_again_ = false;
  FirstResiduals<learning_samples> first_;
  std::optional<bool> young_up_;  ///< the side of the alarm that rose just behind the learning
  Cusum cusum_;
  ShapeTest shape_;
  MaybeLate late_;
};

}  // namespace drydock::consistency
