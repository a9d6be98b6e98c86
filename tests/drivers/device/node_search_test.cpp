// Tests who asks for the NAMEs on a bus, and when. The request's bytes follow SAE J1939-21: PGN
// 59904 (EA00h), priority 6, to all (FFh) from the null address (FEh), for EE00h.
#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace node_search_test {

constexpr std::uint32_t request_id = 0x18EA'FFFE;
constexpr std::initializer_list<unsigned> some_name{0xBC, 0x0A, 0, 0, 0, 0, 0, 0x80};

struct Bus {
  explicit Bus(Kind kind, const std::string& protocol) : driver(make(kind, protocol)) {}
  static std::unique_ptr<FrameDriver> make(Kind kind, const std::string& protocol) {
    DriverOptions o = options(kind, protocol);
    o.address = 0x23;
    return frame_driver(o);
  }
  void says(std::uint32_t id, std::initializer_list<unsigned> data, double at) {
    driver->receive(can_frame(id, true, data), at_s(at), ear);
  }
  void run_to(double end) {
    for (auto due = driver->deadline(); due && *due <= at_s(end); due = driver->deadline()) {
      ticked_s.push_back(measurement::seconds(due->time_since_epoch()));
      driver->tick(*due, ear);
    }
  }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
  std::vector<double> ticked_s;
};

void expect_request(const wire::CanFrame& frame) {
  EXPECT_TRUE(frame.extended);
  EXPECT_EQ(frame.id, request_id);
  EXPECT_EQ(Octets(frame.data.begin(), frame.data.begin() + frame.size), (Octets{0, 0xEE, 0}));
}

struct Case {
  Kind kind;
  const char* protocol;
};
void PrintTo(const Case& c, std::ostream* out) { *out << to_string(c.kind); }

class EachJ1939Driver : public testing::TestWithParam<Case> {};

TEST_P(EachJ1939Driver, AsksWhenTheBusOpensAndEveryTenSecondsOfSilence) {
  Bus bus(GetParam().kind, GetParam().protocol);
  EXPECT_EQ(bus.driver->deadline(), std::nullopt) << "no bus yet";
  bus.driver->restart(at_s(1), bus.ear);
  bus.run_to(31);
  ASSERT_EQ(bus.ear.sent_frames.size(), 4U);
  for (const auto& frame : bus.ear.sent_frames) expect_request(frame);
  EXPECT_EQ(bus.ticked_s, (std::vector<double>{11, 21, 31}));
}

INSTANTIATE_TEST_SUITE_P(Drivers, EachJ1939Driver,
                         testing::Values(Case{Kind::depth, "nmea2000"},
                                         Case{Kind::actuator, "nmea2000"},
                                         Case{Kind::gnss, "nmea2000"},
                                         Case{Kind::emlog, "nmea2000"}, Case{Kind::imu, "aceinna"}),
                         testing::PrintToStringParamName());

// canboat's analyzer_tests/pgn-test.in spans 15 years: asked every 10 s, that were 48 million
// times.
TEST(NodeSearch, ASilenceOfYearsIsCrossedInAFewHundredSteps) {
  Bus bus(Kind::depth, "nmea2000");
  bus.driver->restart(at_s(0), bus.ear);
  bus.run_to(4.8e8);
  EXPECT_LT(bus.ticked_s.size(), 300u);
  EXPECT_GT(bus.ticked_s.size(), 100u);
}

TEST(NodeSearch, ASensorThatIsHeardIsNotAskedFor) {
  Bus bus(Kind::depth, "nmea2000");
  bus.driver->restart(at_s(0), bus.ear);
  for (int t = 0; t < 60; ++t) {
    bus.says(0x15FD0A23, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF}, t);
    bus.run_to(t);
  }
  EXPECT_EQ(bus.ear.sent_frames.size(), 1U);
  EXPECT_TRUE(bus.ticked_s.empty());
}

TEST(NodeSearch, TheAnswerLeadsToASensorWhoseNewClaimWasNotHeard) {
  Bus bus(Kind::depth, "nmea2000");
  bus.driver->restart(at_s(0), bus.ear);
  bus.says(0x18EEFF23, some_name, 0.1);
  bus.says(0x15FD0A23, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF}, 0.4);
  ASSERT_EQ(bus.ear.heard.size(), 1U);

  bus.says(0x15FD0A80, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF}, 9);  // now from 128
  bus.run_to(10.4);
  EXPECT_EQ(bus.ear.heard.size(), 1U);
  EXPECT_EQ(bus.ear.sent_frames.size(), 2U) << "ten seconds after it was last heard";
  bus.says(0x18EEFF80, some_name, 10.5);
  bus.says(0x15FD0A80, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF}, 10.6);
  EXPECT_EQ(bus.ear.heard.size(), 2U);
}

}  // namespace node_search_test
}  // namespace drydock::device::test
