#include <gtest/gtest.h>

#include <map>

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "tests/drivers/bus/wire_reader.hpp"

/// Recordings and viewers get the same bytes as DDS sends.
namespace drydock::bus::test {
namespace {

using namespace measurement;

/// Keeps the last message of each topic.
class Kept final : public CdrSink {
 public:
  std::uint32_t add_topic(const Topic& topic) override {
    names_.push_back(topic.name);
    return static_cast<std::uint32_t>(names_.size() - 1);
  }
  bool wanted(std::uint32_t) const override { return true; }
  void put(std::uint32_t topic, Stamp, std::span<const std::uint8_t> cdr) override {
    last[names_[topic]].assign(cdr.begin(), cdr.end());
  }
  std::map<std::string, std::vector<std::uint8_t>> last;

 private:
  std::vector<std::string> names_;
};

template <class Message, class... Arguments>
void expect_the_same(const std::string& topic, const Arguments&... published) {
  Kept kept;
  CdrPublisher publisher(kept, ros_devices(), {"leveling"});
  publisher.publish(published...);
  auto sent = Wire<Message>("rt" + topic).publish(published...).bytes();
  // A DDS packet is padded to four bytes. The fourth byte of its head gives the number of padding
  // bytes.
  sent.resize(sent.size() - sent[3]);
  sent[3] = 0;
  EXPECT_EQ(kept.last[topic], sent) << topic;
}

TEST(BusOnTheWire, ARecordingGetsTheBytesThatDdsSends) {
  expect_the_same<ImuMessage>("/imu/data",
                              Measurement{ImuSample{origin(imu), {0.5, -0.25, -9.81}, {1, 2, 3}}});
  auto dvl_sample = only_origin<BottomVelocity>(dvl);
  dvl_sample.velocity = Eigen::Vector3d(1.5, 0.1, -0.2);
  expect_the_same<DvlMessage>("/dvl/data", Measurement{dvl_sample});
  expect_the_same<BottomTrackMessage>("/dvl/bottom_track", Measurement{dvl_sample});
  expect_the_same<TwistMessage>("/log/twist",
                                Measurement{WaterSpeed{origin(log), 2.0, {}, 7.0, {}}});
  auto sky = only_origin<GnssSatellites>(gnss);
  sky.satellites.push_back({Constellation::galileo, 7, 41.0, 0.5, 1.5, true});
  sky.satellites.push_back({Constellation::gps, 12, {}, 0.1, 3.0, false});
  expect_the_same<GnssSatellitesMessage>("/gps/satellites", Measurement{sky});
  expect_the_same<ImuMessage>("/estimate/leveling",
                              Attitude{origin(imu).valid_at, 0.1, 0.2, {}, {}}, std::size_t{0});
  const std::vector<DeviceStatus> health{
      {Level::warn, "dvl", "no bottom lock", "serial:/dev/ttyS0", {{"beams", "2"}}}};
  expect_the_same<DiagnosticsMessage>("/diagnostics", std::span<const DeviceStatus>(health),
                                      origin(dvl).valid_at);
}

}  // namespace
}  // namespace drydock::bus::test
