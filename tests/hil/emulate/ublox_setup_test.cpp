#include "drivers/device/gnss/ublox_setup.hpp"

#include <gmock/gmock.h>

#include "tests/hil/emulate/ublox_host.hpp"
#include "tests/test_name.hpp"

/// The setup of our driver and the emulated receivers, which were written apart from each other.
namespace drydock::emulate {
namespace ublox_setup_test {

using rig_config::UbloxModel;
using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint16_t nav_pvt = 0x0107, nav_sat = 0x0135, gga = 0xF000, nav_svinfo = 0x0130;

/// The driver's end of a line to an emulated receiver.
class Line final : public device::Output {
 public:
  explicit Line(UbloxHost& host) : host_(host) {}

  void publish(const device::Measurement&) override {}
  void send(std::span<const std::uint8_t> bytes) override {
    said.emplace_back(bytes.begin(), bytes.end());
  }
  void send(const wire::CanFrame&) override {}
  void report(std::string_view text) override { reports.emplace_back(text); }

  /// Carries what both say until both are silent.
  void run(device::UbloxSetup& setup) {
    setup.start(host_.now, *this);
    for (std::size_t next = 0; next < said.size(); ++next)
      for (const auto& answer : host_.say(said[next])) setup.receive(answer, host_.now, *this);
  }

  std::vector<std::vector<std::uint8_t>> said;
  std::vector<std::string> reports;

 private:
  UbloxHost& host_;
};

class UbloxSetupOf : public testing::TestWithParam<UbloxModel> {};

TEST_P(UbloxSetupOf, TurnsAReceiverToTheRateAndTheMessagesThatAreWanted) {
  UbloxHost host(GetParam());
  Line line(host);
  device::UbloxSetup setup({milliseconds{200}, {{nav_pvt, 1}, {nav_sat, 5}, {gga, 0}}});
  line.run(setup);
  EXPECT_TRUE(setup.finished());
  EXPECT_THAT(line.reports, IsEmpty());
  host.listen(10);  // with the epochs at both ends
  EXPECT_EQ(host.count(nav_pvt), 51U);
  EXPECT_EQ(host.count(nav_sat), 10U);
  EXPECT_THAT(host.all<wire::Gga>(), IsEmpty());
}

TEST_P(UbloxSetupOf, LeavesAReceiverAloneThatIsAlreadySo) {
  UbloxHost host(GetParam());
  Line first(host), again(host);
  device::UbloxSetup setup({milliseconds{200}, {{nav_pvt, 1}}});
  first.run(setup);
  const auto told = host.told.size();
  again.run(setup);
  EXPECT_EQ(again.said.size(), 3U) << "CFG-PRT, CFG-RATE and CFG-MSG, each asked once";
  EXPECT_THAT(again.reports, IsEmpty());
  EXPECT_LE(host.told.size(), told + 3);
}

INSTANTIATE_TEST_SUITE_P(Models, UbloxSetupOf, testing::Values(UbloxModel::m8, UbloxModel::f9),
                         [](const auto& one) { return one.param == UbloxModel::m8 ? "m8" : "f9"; });

// NAV-SVINFO is no message of an F9.
TEST(UbloxSetup, SaysAMessageThatTheModelDoesNotHave) {
  UbloxHost host(UbloxModel::f9);
  Line line(host);
  device::UbloxSetup setup({{}, {{nav_svinfo, 1}, {nav_sat, 1}}});
  line.run(setup);
  EXPECT_THAT(line.reports, ElementsAre("the receiver refuses CFG-MSG of NAV-SVINFO"));
  host.listen(10);
  EXPECT_EQ(host.count(nav_sat), 11U);
}

// The shortest period is 25 ms, UBX-18010854.
TEST(UbloxSetup, SaysAPeriodThatTheReceiverRefuses) {
  UbloxHost host(UbloxModel::m8);
  Line line(host);
  device::UbloxSetup setup({milliseconds{1}, {}});
  line.run(setup);
  EXPECT_THAT(line.reports, ElementsAre("the receiver refuses CFG-RATE"));
}

}  // namespace ublox_setup_test
}  // namespace drydock::emulate
