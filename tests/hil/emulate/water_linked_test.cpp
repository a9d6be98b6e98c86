#include <gtest/gtest.h>

#include "drivers/wire/dvl/water_linked.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;
namespace wl = wire::water_linked;

class WaterLinkedDvl : public testing::Test {
 protected:
  WaterLinkedDvl() : trajectory_(under_way()) {
    config_.emulate.latency_s = 0.04;
    dvl_ = make_emulated_device(config_, trajectory_, 1).value();
  }

  /// The letters of the messages until `seconds` after its boot.
  std::string sent_until(double seconds) {
    recorder_.messages.clear();
    recorder_.run(*dvl_, at_s(seconds));
    std::string names;
    for (const auto& message : recorder_.messages) names += text(message).substr(2, 1);
    return names;
  }

  std::string answer_to(std::string_view command) {
    recorder_.messages.clear();
    const std::string line = std::string(command) + "\r\n";
    dvl_->receive({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, start,
                  recorder_);
    return recorder_.messages.empty() ? "" : text(recorder_.messages.front());
  }

  Frozen trajectory_;
  rig_config::DeviceConfig config_ = device(DeviceKind::dvl, "water-linked", 5);
  std::unique_ptr<EmulatedDevice> dvl_;
  Recorder recorder_;
};

TEST_F(WaterLinkedDvl, TheReportHoldsTheTruthAndItsAge) {
  EXPECT_EQ(sent_until(0.1), "zuuuu");
  const auto& bytes = recorder_.messages.front().bytes;
  EXPECT_EQ(wire::WaterLinked::scan(bytes), wire::Scan::frame(bytes.size()));
  const auto m = std::get<wl::BottomVelocity>(wire::WaterLinked::decode(bytes).value());
  EXPECT_EQ(m.velocity_mps, (wl::Velocity{2.0, 0.123, -0.045}));
  EXPECT_NEAR(*m.altitude_m, 30, 0.005);
  EXPECT_EQ(m.validity, start.time_since_epoch());
  EXPECT_EQ(*m.transmission - *m.validity, std::chrono::milliseconds{40});
}

TEST_F(WaterLinkedDvl, AnswersAsTheVendorDescribes) {
  EXPECT_EQ(answer_to("wcv"), "wrv,2,7,0*f3\r\n");
  EXPECT_EQ(answer_to("wcc").substr(0, 28), "wrc,1475.00,0.00,y,n,auto,y*");
  EXPECT_EQ(answer_to("wcr"), "wra*d9\r\n");
  EXPECT_EQ(answer_to("wcp,2"), "wrn*f4\r\n");
  EXPECT_EQ(answer_to("wcq"), "wr?*44\r\n");
  EXPECT_EQ(answer_to("wcs,fast,,,,,"), "wr?*44\r\n");
  EXPECT_EQ(answer_to("wcv*00"), "wr!*1e\r\n");
}

TEST_F(WaterLinkedDvl, TurnsItsVelocityByTheMountingRotation) {
  EXPECT_EQ(answer_to("wcs,,90,,,,"), "wra*d9\r\n");
  EXPECT_EQ(sent_until(0.1), "zuuuu");
  // The DVL points to starboard: its forward is the vehicle's starboard, its starboard is astern.
  EXPECT_EQ(text(recorder_.messages.front()).substr(0, 24), "wrz,-0.123,2.000,-0.045,");
}

TEST_F(WaterLinkedDvl, RefusesWhatItCannotDo) {
  for (const char* command :
       {"wcs,999,,,,,", "wcs,2001,,,,,", "wcs,,361,,,,", "wcs,,,,,wt,", "wcp,6", "wcp,9"}) {
    EXPECT_EQ(answer_to(command), "wrn*f4\r\n") << command;
  }
  EXPECT_EQ(answer_to("wcc").substr(0, 28), "wrc,1475.00,0.00,y,n,auto,y*");
}

TEST_F(WaterLinkedDvl, SendsTheFormsThatAreAskedFor) {
  EXPECT_EQ(answer_to("wcp,1"), "wra*d9\r\n");
  EXPECT_EQ(sent_until(0.1), "zxuuuut");
  answer_to("wcp,0");
  EXPECT_EQ(sent_until(0.3), "");
}

TEST_F(WaterLinkedDvl, WithAcousticsOffItPingsWhenToldTo) {
  EXPECT_EQ(answer_to("wcs,1450,,n,,,"), "wra*d9\r\n");
  EXPECT_EQ(answer_to("wcc").substr(0, 20), "wrc,1450.00,0.00,n,n");
  EXPECT_EQ(sent_until(0.1), "");
  answer_to("wcx");
  EXPECT_EQ(sent_until(0.5), "zuuuu");
}

TEST_F(WaterLinkedDvl, BeyondItsRangeNothingIsValid) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 400;
  const Frozen deep(truth);
  const auto sent = record(config_, deep, 0.1);
  EXPECT_EQ(text(sent.messages.at(0)).substr(0, 30), "wrz,0.000,0.000,0.000,n,-1.00,");
  EXPECT_EQ(text(sent.messages.at(1)).substr(0, 21), "wru,0,0.000,-1.00,-95");
}

}  // namespace
}  // namespace drydock::emulate
