#include <algorithm>

#include "tests/drivers/described/heard_of.hpp"

/// A boat's log, of gpsd's tests: each second DPT, MTW and DBT of one sounder.
namespace drydock::described::test {
namespace sounder_log_test {

// grep -c: 149 sentences DPT, of which the first comes before any of the 148 DBT.
TEST(DescribedSounder, ThatSaysDptAndDbtHasOneHeightAnEpoch) {
  const auto file = wire::testing::corpora() / "gps/gpsd/daemon/bundg_zeus_9.log";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no corpora";
  const auto bytes = wire::testing::read_file(file);
  const auto heard = heard_of("nmea-depth.toml", std::string(bytes.begin(), bytes.end()));
  const auto heights = std::ranges::count_if(heard.all, [](const auto& m) {
    return std::get<measurement::DepthSample>(m).altitude_m.has_value();
  });
  EXPECT_EQ(heights, 149);
}

}  // namespace sounder_log_test
}  // namespace drydock::described::test
