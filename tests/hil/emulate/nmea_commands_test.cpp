#include <gmock/gmock.h>

#include "drivers/shell/lockstep.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace nmea_commands_test {

using testing::ElementsAre;
using testing::IsEmpty;

class NmeaHost : public testing::Test, protected Wire {
 protected:
  void send(wire::Bytes bytes) override { lines.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame&) override {}
  void set_baud(unsigned baud) override { bauds.push_back(baud); }

  std::vector<std::string> say(std::string_view line) {
    lines.clear();
    device_->receive({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, now, *this);
    return lines;
  }
  /// The formatters of what it sends by itself.
  std::vector<std::string> listen(double seconds) {
    lines.clear();
    const Stamp end = now + measurement::from_seconds(seconds);
    for (auto due = device_->deadline(); due && *due <= end; due = device_->deadline()) {
      now = *due;
      device_->tick(now, *this);
    }
    now = end;
    std::vector<std::string> names;
    for (const auto& line : lines) names.push_back(line.substr(3, 3));
    return names;
  }

  Frozen trajectory_{at_the_surface()};
  std::unique_ptr<EmulatedDevice> device_ =
      make_emulated_device(device(rig_config::DeviceKind::gnss, "nmea0183"), trajectory_, 1)
          .value();
  Stamp now = start;
  std::vector<std::string> lines;
  std::vector<unsigned> bauds;
};

TEST_F(NmeaHost, AnEpochBeginsWithPositionSpeedAndCourse) {
  EXPECT_THAT(listen(0.5), ElementsAre("RMC", "GGA", "VTG", "GSA", "GSV", "GSV", "GSV", "ZDA"));
}

TEST_F(NmeaHost, ObeysTheSentencesAndThePeriodOfPmtk) {
  EXPECT_THAT(say("$PMTK220,200*2C\r\n"), ElementsAre("$PMTK001,220,3*30\r\n"));
  EXPECT_THAT(say("$PMTK314,0,1,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0*28\r\n"),
              ElementsAre("$PMTK001,314,3*36\r\n"));
  const auto names = listen(0.9);
  EXPECT_THAT(names,
              ElementsAre("RMC", "GGA", "RMC", "GGA", "RMC", "GGA", "RMC", "GGA", "RMC", "GGA"));
}

TEST_F(NmeaHost, RefusesWhatIsOutOfRangeAndSaysWhatItDoesNotKnow) {
  EXPECT_THAT(say("$PMTK220,20*1C\r\n"), ElementsAre("$PMTK001,220,2*31\r\n"));
  EXPECT_THAT(say("$PMTK999,1*26\r\n"), ElementsAre("$PMTK001,999,1*3B\r\n"));
  EXPECT_THAT(say("$PMTK220,200*00\r\n"), IsEmpty()) << "a bad checksum";
}

TEST_F(NmeaHost, ObeysTheRatesAndTheBaudRateOfPubx) {
  say("$PUBX,40,GSV,0,0,0,0,0,0*59\r\n");
  say("$PUBX,40,ZDA,0,2,0,0,0,0*46\r\n");
  EXPECT_THAT(listen(1.5),
              ElementsAre("RMC", "GGA", "VTG", "GSA", "RMC", "GGA", "VTG", "GSA", "ZDA"));
  say("$PUBX,41,1,0007,0003,19200,0*25\r\n");
  say("$PMTK251,38400*27\r\n");
  EXPECT_THAT(bauds, ElementsAre(19200, 38400));
}

/// A client that needs RMC, GGA and VTG within 150 ms: 3 sentences of at most 82 characters.
TEST(EmulatedNmeaReceiver, At9600BaudPositionSpeedAndCourseEndWithin150Milliseconds) {
  const Frozen trajectory(at_the_surface());
  std::vector<std::pair<std::string, Stamp>> ends;
  EmulatedLine line(
      make_emulated_device(device(rig_config::DeviceKind::gnss, "nmea0183"), trajectory, 1).value(),
      9600, [&](wire::Bytes bytes, const Passage& passage) {
        ends.emplace_back(std::string(bytes.begin() + 3, bytes.begin() + 6), passage.ended_at);
      });
  shell::Lockstep lockstep(start);
  lockstep.add(line);
  lockstep.run_until(at_s(3));
  double longest = 0;
  for (std::size_t i = 0; i + 2 < ends.size(); ++i)
    if (ends[i].first == "RMC") {
      EXPECT_EQ(ends[i + 2].first, "VTG");
      longest = std::max(longest, measurement::seconds(ends[i + 2].second - ends[i].second));
    }
  EXPECT_GT(longest, 0.05);
  EXPECT_LT(longest, 0.15) << "GGA and VTG are 120 characters";
}

}  // namespace nmea_commands_test
}  // namespace drydock::emulate
