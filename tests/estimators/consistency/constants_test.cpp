#include "estimators/consistency/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace drydock::consistency {
namespace {

using measurement::from_seconds;

class Remembered final : public diagnosis::SymptomSink {
 public:
  void see(const diagnosis::Symptom& symptom) override { last = symptom; }
  std::optional<diagnosis::Symptom> last;
};

/// A vehicle at 1.5 m/s that dives and rises with a pitch of 15 degrees in 120 s, for 20 min. The
/// DVL says `body(pitch)` of its velocity; the pressure is right.
class Yoyo {
 public:
  using Says = Eigen::Vector3d (*)(double ahead, double pitch);
  enum class Depth { of_a_sensor, of_the_head, told_to_the_head };

  explicit Yoyo(Says says, Depth source = Depth::of_a_sensor) : source_(source) {
    tracks_.dvls.emplace_back(0, Sensor{.kind = measurement::Kind::dvl, .rate_hz = 5});
    if (source_ == Depth::of_a_sensor)
      tracks_.depths.emplace_back(1, Sensor{.kind = measurement::Kind::depth, .rate_hz = 5});
    Constants constants(tracks_);
    double depth = 100;
    for (int i = 0; i < 6000; ++i) {
      const double pitch = 0.26 * std::sin(0.2 * i * 2 * 3.14159265 / 120);
      depth -= 0.2 * ahead * std::sin(pitch);
      take(i, pitch, depth, says(ahead, pitch));
      Moment moment{.at = at(i), .dt = 0.2};
      moment.down = Eigen::Vector3d{-std::sin(pitch), 0, std::cos(pitch)};
      constants.step(moment, [](const Devices&) { return false; });
    }
    constants.tell({}, told_);
  }

  const std::optional<diagnosis::Symptom>& told() const { return told_.last; }

 private:
  static constexpr double ahead = 1.5;
  static measurement::Stamp at(int i) { return measurement::Stamp{} + from_seconds(1 + 0.2 * i); }

  void take(int i, double pitch, double depth, const Eigen::Vector3d& body) {
    measurement::BottomVelocity bottom;
    bottom.origin.valid_at = at(i);
    bottom.velocity = body + 0.01 * Eigen::Vector3d{normal_(random_), 0, normal_(random_)};
    bottom.roll_rad = 0;
    bottom.pitch_rad = pitch;
    if (source_ == Depth::of_the_head) bottom.depth_m = depth + 0.02 * normal_(random_);
    if (source_ == Depth::told_to_the_head) bottom.depth_m = 100;
    consistency::take(tracks_.dvls[0], bottom);
    if (source_ != Depth::of_a_sensor) return;
    measurement::DepthSample read;
    read.origin.valid_at = at(i);
    read.depth_m = depth + 0.02 * normal_(random_);
    consistency::take(tracks_.depths[0], read);
  }

  Depth source_;
  Tracks tracks_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
  Remembered told_;
};

TEST(Constants, SayNothingOfASoundDvl) {
  const Yoyo dive([](double ahead, double) -> Eigen::Vector3d { return {ahead, 0, 0}; });
  EXPECT_FALSE(dive.told());
}

/// Level axes where body axes are expected: ahead cos(pitch), down -ahead sin(pitch).
Eigen::Vector3d levelled(double ahead, double pitch) {
  return {ahead * std::cos(pitch), 0, -ahead * std::sin(pitch)};
}

TEST(Constants, TellTiltsThatWereTakenOutAlready) {
  const Yoyo dive(levelled);
  ASSERT_TRUE(dive.told());
  EXPECT_EQ(dive.told()->sign, diagnosis::Sign::rotated);
  EXPECT_NEAR(dive.told()->value, 100, 5);
  EXPECT_EQ(dive.told()->unit, "%");
}

TEST(Constants, TakeTheHeadsOwnDepthWhereNoOtherSensorTellsOne) {
  const Yoyo dive(levelled, Yoyo::Depth::of_the_head);
  ASSERT_TRUE(dive.told());
  EXPECT_EQ(dive.told()->sign, diagnosis::Sign::rotated);
  EXPECT_NEAR(dive.told()->value, 100, 5);
}

/// A head without a pressure sensor repeats the depth of its settings (EZ, ED of PD0 heads).
TEST(Constants, SayNothingBesideADepthThatTheHeadWasTold) {
  const Yoyo dive(levelled, Yoyo::Depth::told_to_the_head);
  EXPECT_FALSE(dive.told());
}

/// Body axes that were turned back by tilts which they never had.
TEST(Constants, TellTiltsThatWereTakenOutOfDataThatHadNone) {
  const Yoyo dive([](double ahead, double pitch) -> Eigen::Vector3d {
    return {ahead * std::cos(pitch), 0, ahead * std::sin(pitch)};
  });
  ASSERT_TRUE(dive.told());
  EXPECT_NEAR(dive.told()->value, -100, 5);
}

TEST(Constants, TellThePitchOfTheMounting) {
  const Yoyo dive([](double ahead, double) -> Eigen::Vector3d {
    return {ahead * std::cos(0.05), 0, ahead * std::sin(0.05)};
  });
  ASSERT_TRUE(dive.told());
  EXPECT_EQ(dive.told()->unit, "deg");
  EXPECT_NEAR(std::abs(dive.told()->value), 0.05 * 180 / 3.14159265, 0.1);
}

/// Two samples off by +-0.1: s^2 = 0.02 / (2 - 1), and the variance s^2 / sum x^2.
TEST(ConstantFit, IsTheMeanOfTheRatios) {
  ConstantFit<1> fit(ConstantFit<1>::Vector{1000}, 0.1, 0.98);
  for (int i = 0; i < 2; ++i) fit.add(4.1 - 0.2 * i, ConstantFit<1>::Vector{2});
  const auto answer = fit.solve();
  EXPECT_NEAR(answer.value[0], 2, 0.001);
  EXPECT_NEAR(answer.sigma(0), std::sqrt(0.02 / 8), 0.001);
  EXPECT_NEAR(answer.sigma_of(ConstantFit<1>::Vector{3}), 3 * std::sqrt(0.02 / 8), 0.003);
}

TEST(ConstantFit, KeepsToItsPriorWhereTheDataSayNothing) {
  ConstantFit<2> fit({0.01, 1}, 0.1, 0.98);
  for (int i = 0; i < 100; ++i) fit.add(0, {1, 0});
  EXPECT_NEAR(fit.solve().sigma(1), 1, 1e-6);
}

}  // namespace
}  // namespace drydock::consistency
