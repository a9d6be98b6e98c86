#include "drivers/device/bus/pdo_watch.hpp"

#include <gmock/gmock.h>

#include "tests/drivers/device/support.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Drivers of CANopen nodes whose PDOs another master has set up (CiA 301: 1800h, 1A00h).
namespace drydock::device::test {
namespace pdo_watch_test {

using measurement::DepthSample;
using testing::ElementsAre;
using testing::IsEmpty;
using wire::test::frame;
using wire::test::text_of;

DriverOptions node_5() {
  DriverOptions o = options(Kind::depth, "cia404-pressure");
  o.address = 5;
  return o;
}

/// A node that answers by SDO from a table: "4000180100" -> the value's bytes.
struct Bus {
  explicit Bus(const DriverOptions& o = node_5()) : driver(frame_driver(o)) {
    driver->restart(at_s(0), ear);
  }
  void hears(const std::string& text, double at) {
    driver->receive(frame(text), at_s(at), ear);
    for (; answered < ear.sent_frames.size(); ++answered) {
      const auto asked = text_of(ear.sent_frames[answered]);
      if (!asked.starts_with("605#40")) continue;
      ++questions;
      const auto mux = asked.substr(6, 6);
      const auto known = objects.find(mux);
      const auto answer =
          known == objects.end() ? "585#80" + mux + "00000206" : "585#43" + mux + known->second;
      if (answers) hears_later.push_back(answer);
    }
    while (!hears_later.empty()) {
      const auto next = hears_later.front();
      hears_later.erase(hears_later.begin());
      hears(next, at);
    }
  }
  void run(double until) {
    for (auto due = driver->deadline(); due && *due <= at_s(until); due = driver->deadline()) {
      driver->tick(*due, ear);
      hears("77F#05", std::chrono::duration<double>(*due - at_s(0)).count());
    }
  }

  Ear ear;
  std::map<std::string, std::string> objects;
  std::vector<std::string> hears_later;
  std::size_t answered = 0, questions = 0;
  bool answers = true;
  std::unique_ptr<FrameDriver> driver;
};

/// TPDO1 on 1C1h: the status, then the integer.
void map_elsewhere(Bus& bus) {
  bus.objects = {{"001801", "C1010000"},
                 {"001A00", "02000000"},
                 {"001A01", "08015061"},
                 {"001A02", "20013091"}};
}

TEST(PdoWatch, APdoAtAnotherNumberIsReadAsTheNodeSays) {
  Bus bus;
  map_elsewhere(bus);
  bus.hears("705#05", 1);
  bus.hears("1C1#00A0860100", 2);
  EXPECT_THAT(bus.ear.all<DepthSample>(), IsEmpty());
  bus.hears("705#05", 3);
  bus.run(4);
  EXPECT_EQ(bus.questions, 5u) << "1800h:1, 1A00h:0 to 2, 1801h:1";
  EXPECT_THAT(bus.ear.reports,
              ElementsAre("node 5 was set up in another way; it is read as it says (1A00h): 1C1h"));
  bus.hears("1C1#00A0860100", 5);
  const auto samples = bus.ear.all<DepthSample>();
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_NEAR(samples[0].pressure_pa.value(), 1e5, 1e-9);
  bus.hears("185#A086010000", 6);
  bus.hears("1C1#00A086", 6);
  EXPECT_EQ(bus.ear.all<DepthSample>().size(), 1u);
  EXPECT_THAT(bus.ear.refusals, testing::SizeIs(2)) << "nothing is dropped in silence";
}

TEST(PdoWatch, APdoThatIsTooShortIsAskedForAtOnce) {
  Bus bus;
  bus.objects = {{"001801", "85010000"}, {"001A00", "01000000"}, {"001A01", "20013061"}};
  bus.hears("185#00002441", 1);
  EXPECT_THAT(bus.ear.reports,
              ElementsAre("node 5 sends no object 9130h:1, which this protocol reads: see 1A00h of "
                          "the node, or `format` of the rig file"));
  bus.hears("185#00002441", 2);
  EXPECT_EQ(bus.questions, 4u) << "once";
}

TEST(PdoWatch, ANodeThatDoesNotAnswerIsAskedThreeTimes) {
  Bus bus;
  bus.answers = false;
  bus.hears("705#05", 1);
  bus.run(60);
  EXPECT_EQ(bus.questions, 3u);
  ASSERT_FALSE(bus.ear.reports.empty());
  EXPECT_EQ(
      bus.ear.reports[0] == "node 5 lost: no heartbeat for 3 s" ? bus.ear.reports[1]
                                                                : bus.ear.reports[0],
      "node 5's PDO 185h does not come, and it was not heard to say what it sends (1800h, 1A00h)");
}

TEST(PdoWatch, AUsualNodeIsNotAskedAndASlowOneIsLeftAlone) {
  Bus bus;
  bus.hears("705#05", 1);
  bus.hears("185#A086010000", 2);
  bus.run(30);
  EXPECT_EQ(bus.questions, 0u);
  Bus slow;
  slow.objects = {{"001801", "85010000"},
                  {"001A00", "02000000"},
                  {"001A01", "20013091"},
                  {"001A02", "08015061"}};
  slow.hears("705#05", 1);
  slow.run(5);
  slow.hears("185#A086010000", 6);
  EXPECT_EQ(slow.ear.all<DepthSample>().size(), 1u);
  for (const auto& report : slow.ear.reports) EXPECT_EQ(report.find("1A00h"), std::string::npos);
}

TEST(PdoWatch, AfterABootUpTheNodeIsAsUsualAgain) {
  Bus bus;
  map_elsewhere(bus);
  bus.hears("705#05", 1);
  bus.run(4);
  bus.hears("705#00", 5);
  bus.hears("185#A086010000", 6);
  EXPECT_EQ(bus.ear.all<DepthSample>().size(), 1u);
}

TEST(PdoWatch, SamplesOfAnImuComeTogetherFromWhereverTheyAreMapped) {
  DriverOptions o = options(Kind::imu, "cia404-imu");
  o.address = 5;
  Bus bus(o);
  // 185h: rate x and force x; 1C5h: rate y and force y; 2C5h: rate z and force z.
  bus.objects = {{"001801", "85010000"}, {"001A00", "02000000"}, {"001A01", "20013061"},
                 {"001A02", "20043061"}, {"011801", "C5010000"}, {"011A00", "02000000"},
                 {"011A01", "20023061"}, {"011A02", "20053061"}, {"021801", "C5020000"},
                 {"021A00", "02000000"}, {"021A01", "20033061"}, {"021A02", "20063061"}};
  bus.hears("705#05", 1);
  bus.run(4);
  for (const double at : {5.0, 5.1}) {
    bus.hears("185#0000803F0000A0C0", at);          // 1, -5
    bus.hears("1C5#000000400000C0C0", at + 0.001);  // 2, -6
    bus.hears("2C5#00004040000020C1", at + 0.002);  // 3, -10
  }
  bus.driver->finish(bus.ear);
  const auto samples = bus.ear.all<measurement::ImuSample>();
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples[0].angular_rate, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(samples[0].specific_force, Eigen::Vector3d(-5, -6, -10));
}

}  // namespace pdo_watch_test
}  // namespace drydock::device::test
