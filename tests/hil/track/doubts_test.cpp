#include "hil/track/doubts.hpp"

#include <gmock/gmock.h>

namespace drydock::track::doubts_test {
namespace {

using smoothing::Quantity;

/// Fixes of one receiver; `pattern` has an x for each refused one.
std::vector<std::string> doubts(const std::string& pattern) {
  Gathered gathered;
  gathered.rig.devices.resize(1);
  gathered.rig.devices[0].name = "gnss";
  smoothing::Track track;
  for (const char c : pattern) {
    gathered.dive.readings.push_back({.quantity = Quantity::fix});
    std::array<smoothing::Residual, 3> axes{};
    axes[0] = {9, 1, true, c != 'x'};
    track.residuals.push_back(axes);
  }
  return doubts_of(gathered, track);
}

TEST(Doubts, ALongRunOfRefusedFixesIsSaid) {
  EXPECT_THAT(doubts("..xxxxxxxxxxxx...x."),
              testing::ElementsAre(
                  testing::HasSubstr("gnss: 13 of 19 fixes refused, 12 one after the other")));
}

TEST(Doubts, SingleWildFixesAreNotWorthAWord) {
  EXPECT_THAT(doubts(".x.xx.xxx.xxxxxxxxx.x.x.xxxx"), testing::IsEmpty());
}

TEST(Doubts, AScaleThatTheDiveToldIsSaid) {
  smoothing::Track track;
  track.bottom_scale = -0.008;
  track.bottom_scale_sigma = 0.0005;
  EXPECT_THAT(doubts_of({}, track),
              testing::ElementsAre(
                  testing::HasSubstr("bottom track measures 0.80 % too little (1 sigma 0.05 %)")));
  track.bottom_scale_sigma = 0.004;
  EXPECT_THAT(doubts_of({}, track), testing::IsEmpty());
}

}  // namespace
}  // namespace drydock::track::doubts_test
