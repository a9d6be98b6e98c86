#include "drivers/host/finding_log.hpp"

#include <gmock/gmock.h>

#include "drivers/host/finding_lines.hpp"

namespace drydock::host {
namespace finding_log_test {

using diagnosis::Cause;
using diagnosis::Finding;
using measurement::Stamp;
using testing::ElementsAre;
using testing::StartsWith;

constexpr Stamp at(int s) { return Stamp{std::chrono::seconds{s}}; }

Finding finding(std::uint16_t device, Cause cause, int since_s) {
  return {.device = device,
          .cause = cause,
          .since = at(since_s),
          .found = at(since_s + 1),
          .until = {},
          .confidence = 0.9,
          .evidence = {},
          .advice = {}};
}

Finding over(Finding one, int until_s) {
  one.until = at(until_s);
  return one;
}

TEST(FindingLog, HasEachFindingOnceWithItsEnd) {
  FindingLog log;
  const Finding first = finding(0, Cause::damaged, 10), other = finding(1, Cause::silent, 12);
  log.on_finding(first);
  log.on_finding(other);
  log.on_finding(over(first, 20));
  ASSERT_EQ(log.all().size(), 2u);
  EXPECT_EQ(log.all()[0].until, at(20));
  EXPECT_FALSE(log.all()[1].until);
}

TEST(FindingLog, KnowsWhatIsWrongWithADeviceNow) {
  FindingLog log;
  log.on_finding(finding(0, Cause::damaged, 10));
  log.on_finding(over(finding(0, Cause::damaged, 10), 20));
  log.on_finding(finding(0, Cause::silent, 30));
  ASSERT_NE(log.open(0), nullptr);
  EXPECT_EQ(log.open(0)->cause, Cause::silent);
  EXPECT_EQ(log.open(1), nullptr);
}

TEST(FindingLog, TheSameFaultAgainIsAnotherFinding) {
  FindingLog log;
  for (int i = 0; i < 2; ++i) {
    log.on_finding(finding(0, Cause::silent, 100 * i));
    log.on_finding(over(finding(0, Cause::silent, 100 * i), 100 * i + 10));
  }
  EXPECT_EQ(log.all().size(), 2u);
}

TEST(FindingLog, CountsWhatItCannotKeep) {
  FindingLog log;
  for (std::size_t i = 0; i < FindingLog::most + 3; ++i) {
    log.on_finding(finding(0, Cause::silent, static_cast<int>(2 * i)));
    log.on_finding(
        over(finding(0, Cause::silent, static_cast<int>(2 * i)), static_cast<int>(2 * i) + 1));
  }
  EXPECT_EQ(log.all().size(), FindingLog::most);
  EXPECT_EQ(log.not_kept(), 3u);
}

TEST(FindingLines, TellWhenAFindingIsFoundAndWhenItIsOver) {
  rig_config::Rig rig;
  rig.devices.emplace_back().name = "dvl";
  std::vector<std::string> lines;
  FindingLines said(rig, at(100), [&](const std::string& line) { lines.push_back(line); });
  said.on_finding(finding(0, Cause::silent, 106));
  said.on_finding(over(finding(0, Cause::silent, 106), 116));
  EXPECT_THAT(lines, ElementsAre("7.000 s found: dvl: silent since 6.0 s — look at the sensor's "
                                 "power and cable",
                                 "16.000 s dvl: no longer silent after 10.0 s"));
}

}  // namespace finding_log_test
}  // namespace drydock::host
