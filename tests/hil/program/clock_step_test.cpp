// The host's clock is set while the program runs: how long it runs does not change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

#include "tests/hil/program/program.hpp"

namespace clock_step_test {

using program::drydock;
using program::Folder;
using program::Outcome;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// Within two seconds of its start the program sees UTC jump.
std::string step_by(const std::string& seconds) {
  return "LD_PRELOAD=" DRYDOCK_STEPPING_CLOCK
         " ASAN_OPTIONS=verify_asan_link_order=0 STEP_AFTER=2 STEP_BY=" +
         seconds;
}

/// Seconds that the program ran. `timeout` ends one that never would.
double seconds_of(const std::string& arguments, const std::string& step) {
  const auto begin = Clock::now();
  drydock(arguments, step_by(step) + " timeout 20");
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A rig with one log; `more` goes to the end of the file.
std::string rig_file(const Folder& folder, const std::string& link, const std::string& more = {}) {
  const auto path = folder / "rig.toml";
  std::ofstream(path) << "[rig]\nname = \"log\"\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
                         "protocol = \"nmea0183\"\nlink = \""
                      << link << "\"\nrate_hz = 5\n"
                      << more;
  return path.string();
}

class AfterAStep : public testing::TestWithParam<const char*> {};

TEST_P(AfterAStep, DriveAndRecordLastAsLongAsTheyWereTold) {
  const Folder folder;
  const std::string rig = rig_file(folder, "udp:127.0.0.1:24871");
  for (const std::string& command :
       {"drive " + rig, "record " + rig + " -o " + (folder / "dive.mcap").string()}) {
    const double took_s = seconds_of(command + " --for 3s", GetParam());
    EXPECT_GE(took_s, 3) << command;
    EXPECT_LT(took_s, 10) << command;
  }
}

TEST_P(AfterAStep, AProbeListensAsLongAsItWasTold) {
  const double took_s = seconds_of("probe 'udp:127.0.0.1:24872?listen=1' --for 3s", GetParam());
  EXPECT_GE(took_s, 3);
  EXPECT_LT(took_s, 10);
}

/// The device comes after the step. The proxy tries again at least every 5 s.
TEST_P(AfterAStep, AProxyOpensADeviceThatIsBack) {
  const Folder folder;
  const std::string link = "pty:" + (folder / "port").string() + "?baud=38400";
  const auto outcome = drydock(
      "proxy '" + link + "' pty:drivers --for 10s 2>&1 & sleep 3; " DRYDOCK_PROGRAM " emulate " +
          rig_file(folder, link) + " --for 6s > /dev/null; wait",
      step_by(GetParam()));
  EXPECT_THAT(outcome.output, HasSubstr("?baud=38400: open"));
}

TEST_P(AfterAStep, AnExpectationBeginsWhenTheRunIsOldEnough) {
  const Folder folder;
  const std::string rig = rig_file(folder, "pty:log?baud=38400",
                                   "[[expect]]\ndevice = \"log\"\nstate = \"streaming\"\n"
                                   "after_s = 1000\n");
  EXPECT_THAT(drydock("run " + rig + " --for 4s", step_by(GetParam())).output,
              HasSubstr("before after_s = 1000"));
}

INSTANTIATE_TEST_SUITE_P(OfAnHour, AfterAStep, testing::Values("3600", "-3600"));

}  // namespace clock_step_test
