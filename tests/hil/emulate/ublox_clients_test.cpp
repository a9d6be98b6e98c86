#include <gmock/gmock.h>

#include "tests/hil/emulate/ublox_host.hpp"

/// What the drivers of other programs say to a u-blox receiver, in their order, and what they wait
/// for before they go on. Read for these facts: ArduPilot's AP_GPS_UBLOX_CFGv2.cpp, the ROS driver
/// ublox_gps (gps.cpp, node.cpp), Kismet's gps_ubx. Layouts: UBX-13003221, UBX-18010854.
namespace drydock::emulate {
namespace ublox_clients_test {

using Frame = std::vector<std::uint8_t>;
using rig_config::UbloxModel;
using testing::ElementsAre;
namespace ubx = wire::ubx;

constexpr std::uint16_t mon_io = 0x0A02, mon_comms = 0x0A36, mon_rf = 0x0A38;

void add_key(Frame& frame, std::uint32_t key) {
  for (unsigned i = 0; i < 4; ++i) frame.push_back(static_cast<std::uint8_t>(key >> 8 * i));
}
Frame valget(std::initializer_list<std::uint32_t> keys) {
  Frame frame{0, 0, 0, 0};
  for (const auto key : keys) add_key(frame, key);
  return frame;
}
std::vector<std::uint8_t> answer_to(UbloxHost& host, std::uint16_t id, const Frame& payload = {}) {
  const auto answers = host.say(id, payload);
  if (answers.empty() || ubx::packet_of(answers[0]).class_and_id != id) return {};
  const auto answer = ubx::packet_of(answers[0]).payload;
  return {answer.begin(), answer.end()};
}
std::uint32_t u32(const Frame& payload, std::size_t at) {
  return wire::load_le<std::uint32_t>(payload, at);
}

/// A host learns its port from MON-COMMS: the one that has received something. ArduPilot stays
/// there until it is answered.
TEST(UbloxClients, AnF9TellsByMonCommsWhichPortTheHostIsAt) {
  UbloxHost host(UbloxModel::f9);
  host.listen(2);
  const Frame first = answer_to(host, mon_comms);
  ASSERT_EQ(first.size(), 8u + 5 * 40);
  EXPECT_EQ(first[0], 0) << "version";
  EXPECT_EQ(first[1], 5) << "ports";
  EXPECT_THAT(Frame(first.begin() + 4, first.begin() + 8), ElementsAre(0, 1, 5, 0xFF))
      << "UBX, NMEA, RTCM 3";
  std::vector<std::uint16_t> ports;
  for (std::size_t at = 8; at < first.size(); at += 40) {
    ports.push_back(wire::load_le<std::uint16_t>(first, at));
    const bool ours = ports.back() == 0x0100;
    EXPECT_EQ(u32(first, at + 4) > 0, ours) << "bytes sent";
    EXPECT_EQ(u32(first, at + 12), ours ? 8u : 0u) << "bytes received: this poll";
    for (const std::size_t usage : {8u, 9u, 16u, 17u})
      EXPECT_EQ(first[at + usage] > 0, ours) << "percent of a buffer at " << usage;
  }
  EXPECT_THAT(ports, ElementsAre(0x0000, 0x0100, 0x0201, 0x0300, 0x0400));
  const Frame second = answer_to(host, mon_comms);
  EXPECT_EQ(u32(second, 8 + 40 + 12), 16u);
  EXPECT_EQ(u32(second, 8 + 40 + 4) - u32(first, 8 + 40 + 4), 8u + 208) << "the answer itself";
}

TEST(UbloxClients, AnM8TellsByMonIoWhichPortTheHostIsAt) {
  UbloxHost host(UbloxModel::m8);
  EXPECT_TRUE(host.say(mon_comms).empty()) << "an M8 has no such message";
  const Frame ports = answer_to(host, mon_io);
  ASSERT_EQ(ports.size(), 6u * 20);
  for (std::size_t port = 0; port < 6; ++port)
    EXPECT_EQ(u32(ports, 20 * port), port == 1 ? 16u : 0u) << port;
}

/// The settings of ArduPilot's CFGv2: the group of signals, then those of its list for a receiver
/// with two UARTs. It compares what it reads with what it wants, and writes until they are the
/// same.
TEST(UbloxClients, AnF9IsConfiguredByTheKeysOfArduPilot) {
  UbloxHost host(UbloxModel::f9);
  const Frame signals = answer_to(host, ubx::cfg_valget, valget({0x1031FFFF}));
  EXPECT_EQ((signals.size() - 4) % 5, 0u);
  EXPECT_GE(signals.size(), 4 + 5 * 16u);
  const auto keys =
      valget({0x30210002, 0x20910007, 0x20910048, 0x20910039, 0x2091035A, 0x20910008, 0x20910049,
              0x2091003A, 0x2091035B, 0x20110021, 0x201100A4, 0x30210001});
  EXPECT_EQ(answer_to(host, ubx::cfg_valget, keys).size(), 4 + 10 * 5 + 2 * 6u);
  Frame set{1, 7, 0, 0};
  for (const auto& [key, value] : std::vector<std::pair<std::uint32_t, std::uint8_t>>{
           {0x20910048, 5}, {0x20910039, 1}, {0x2091035A, 5}, {0x20110021, 8}}) {
    add_key(set, key);
    set.push_back(value);
  }
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, set));
  EXPECT_THAT(answer_to(host, ubx::cfg_valget, valget({0x2091035A})),
              ElementsAre(1, 0, 0, 0, 0x5A, 0x03, 0x91, 0x20, 5));
  host.listen(9.9);
  EXPECT_EQ(host.count(mon_rf), 2u);
  EXPECT_EQ(host.count(0x0120), 2u);
}

/// MON-RF: two bands, healthy antenna, no jamming; PX4 and ArduPilot read them.
TEST(UbloxClients, TheRadioOfAnF9IsHealthy) {
  UbloxHost host(UbloxModel::f9);
  const Frame radio = answer_to(host, mon_rf);
  ASSERT_EQ(radio.size(), 4u + 2 * 24);
  EXPECT_EQ(radio[1], 2) << "bands";
  for (const std::size_t band : {0u, 1u}) {
    const std::size_t at = 4 + 24 * band;
    EXPECT_EQ(radio[at], band);
    EXPECT_THAT(Frame(radio.begin() + at + 1, radio.begin() + at + 4), ElementsAre(0, 2, 1))
        << "jamming unknown, antenna OK, powered";
  }
  UbloxHost old(UbloxModel::m8);
  EXPECT_TRUE(old.say(mon_rf).empty());
  EXPECT_FALSE(old.acknowledges(ubx::cfg_msg, {0x0A, 0x38, 1}));
}

/// ArduPilot's reset to the settings as delivered: all keys by their wildcard, from the layers that
/// keep, then a controlled restart.
TEST(UbloxClients, AnF9ForgetsAllItWasToldByTheWildcardOfAllKeys) {
  UbloxHost host(UbloxModel::f9);
  Frame set{1, 7, 0, 0, 0x01, 0x00, 0x21, 0x30, 200, 0};
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, set));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valdel, {1, 6, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF}));
  EXPECT_THAT(answer_to(host, ubx::cfg_valget, {0, 0, 0, 0, 1, 0, 0x21, 0x30}),
              ElementsAre(1, 0, 0, 0, 1, 0, 0x21, 0x30, 200, 0))
      << "RAM keeps it";
  EXPECT_TRUE(host.say(ubx::cfg_rst, {0, 0, 1, 0}).empty());
  EXPECT_THAT(answer_to(host, ubx::cfg_valget, {0, 0, 0, 0, 1, 0, 0x21, 0x30}),
              ElementsAre(1, 0, 0, 0, 1, 0, 0x21, 0x30, 0xE8, 0x03));
}

/// NAV-TIMEUTC, from which Altus Metrum's driver and older ones take the time: 22:13:20.5 UTC.
TEST(UbloxClients, BothModelsTellTheTimeInUtc) {
  for (const auto model : {UbloxModel::m8, UbloxModel::f9}) {
    UbloxHost host(model, 2);
    EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, 0x21, 1}));
    host.listen(0.9);
    EXPECT_EQ(host.count(0x0121), 2u);
    const Frame time = answer_to(host, 0x0121);
    ASSERT_EQ(time.size(), 20u);
    EXPECT_EQ(u32(time, 0) % 1000, 500u) << "time of week, ms";
    EXPECT_EQ(u32(time, 8), 500'000'000u) << "ns";
    EXPECT_THAT(Frame(time.begin() + 12, time.end()),
                ElementsAre(0xE7, 0x07, 11, 14, 22, 13, 20, 0x37));
  }
}

/// Settings that real receivers of both kinds take, poll and length as in the documents. A host
/// that is refused one gives up: the ROS driver ends with "Failed to configure NMEA" or "PPP".
class UbloxTakes : public testing::TestWithParam<UbloxModel> {};
INSTANTIATE_TEST_SUITE_P(Models, UbloxTakes, testing::Values(UbloxModel::m8, UbloxModel::f9),
                         [](const auto& param) {
                           return std::string(param.param == UbloxModel::m8 ? "M8" : "F9");
                         });

TEST_P(UbloxTakes, SettingsThatChangeNothingHereAndTellsThemAgain) {
  struct Setting {
    std::uint16_t id;
    std::size_t size;
    Frame poll;
  };
  UbloxHost host(GetParam());
  for (const auto& [id, size, poll] : std::vector<Setting>{{0x0602, 10, {1}},   // INF of NMEA
                                                           {0x0613, 4, {}},     // ANT
                                                           {0x0617, 20, {}},    // NMEA
                                                           {0x061E, 20, {}},    // ODO
                                                           {0x0623, 40, {}},    // NAVX5
                                                           {0x0631, 32, {0}},   // TP5
                                                           {0x0639, 8, {}}}) {  // ITFM
    SCOPED_TRACE(id);
    const auto answers = host.say(id, poll);
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(ubx::packet_of(answers[0]).class_and_id, id);
    ASSERT_EQ(ubx::packet_of(answers[0]).payload.size(), size);
    EXPECT_EQ(ubx::packet_of(answers[1]).class_and_id, ubx::ack_ack);
    Frame changed(answers[0].begin() + 6, answers[0].end() - 2);
    changed.back() ^= 1;
    EXPECT_TRUE(host.acknowledges(id, changed));
    EXPECT_EQ(answer_to(host, id, poll), changed);
    changed.push_back(0);
    changed.push_back(0);
    changed.push_back(0);
    EXPECT_FALSE(host.acknowledges(id, changed)) << "a wrong length";
  }
  host.say(ubx::cfg_rst, {0, 0, 1, 0});
  EXPECT_EQ(answer_to(host, 0x0639)[7], 0) << "as delivered after a restart";
}

/// A message that a real receiver has and this one never sends: its rate is taken and told. Other
/// hosts ask for them all, as gpsd and the ROS driver do.
TEST_P(UbloxTakes, RatesOfMessagesThatItNeverSends) {
  UbloxHost host(GetParam());
  for (const Frame& message : std::vector<Frame>{{0x01, 0x01},
                                                 {0x01, 0x11},
                                                 {0x01, 0x21},
                                                 {0x01, 0x22},
                                                 {0x01, 0x26},
                                                 {0x01, 0x32},
                                                 {0xF0, 0x07},
                                                 {0xF0, 0x0D},
                                                 {0xF1, 0x00}}) {
    SCOPED_TRACE(message[0] << 8 | message[1]);
    EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {message[0], message[1], 2}));
    EXPECT_EQ(answer_to(host, ubx::cfg_msg, message).at(3), 2) << "on UART1";
  }
  EXPECT_FALSE(host.acknowledges(ubx::cfg_msg, {0x01, 0x7F, 1})) << "nobody has it";
  EXPECT_EQ(host.acknowledges(ubx::cfg_msg, {0x01, 0x43, 1}), GetParam() == UbloxModel::f9)
      << "NAV-SIG";
}

}  // namespace ublox_clients_test
}  // namespace drydock::emulate
