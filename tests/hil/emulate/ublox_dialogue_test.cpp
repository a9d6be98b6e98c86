#include <gmock/gmock.h>

#include "drivers/shell/lockstep.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/hil/emulate/ublox_host.hpp"
#include "tests/test_name.hpp"

namespace drydock::emulate {
namespace ublox_dialogue_test {

using rig_config::UbloxModel;
using testing::ElementsAre;
using testing::IsEmpty;
using Frame = std::vector<std::uint8_t>;
namespace ubx = wire::ubx;

Frame bytes_of(std::string_view hex) {
  Frame bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(
        static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
  return bytes;
}

struct Exchange {
  std::string what;
  Frame said;
  std::vector<Frame> answers;
};

/// fixtures/boxes/ublox/NOTE.md
std::vector<Exchange> dialogue_of(const std::string& model) {
  std::ifstream file(DRYDOCK_SOURCE_DIR "/fixtures/boxes/ublox/" + model + ".txt");
  std::vector<Exchange> all;
  std::string what;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') what = line.substr(2);
    if (line[0] == '>') all.push_back({what, bytes_of(line.substr(2)), {}});
    if (line[0] == '<') all.back().answers.push_back(bytes_of(line.substr(2)));
  }
  return all;
}

class UbloxDialogueGolden : public testing::TestWithParam<const char*> {};

TEST_P(UbloxDialogueGolden, AnswersEachFrameWithTheBytesOfTheDocuments) {
  const std::string model = GetParam();
  UbloxHost host(model == "m8" ? UbloxModel::m8 : UbloxModel::f9);
  const auto dialogue = dialogue_of(model);
  ASSERT_GT(dialogue.size(), 15u);
  for (const auto& [what, said, answers] : dialogue) EXPECT_EQ(host.say(said), answers) << what;
}

INSTANTIATE_TEST_SUITE_P(Models, UbloxDialogueGolden, testing::Values("m8", "f9"),
                         [](const auto& one) { return std::string(one.param); });

TEST(EmulatedUblox, AFrameThatComesByteByByteIsAnsweredOnce) {
  UbloxHost host(UbloxModel::m8);
  const auto dialogue = dialogue_of("m8");
  const Frame& poll = dialogue.front().said;
  for (std::size_t i = 0; i + 1 < poll.size(); ++i)
    EXPECT_THAT(host.say(wire::Bytes{poll}.subspan(i, 1)), IsEmpty());
  EXPECT_EQ(host.say(wire::Bytes{poll}.last(1)), dialogue.front().answers);
}

/// Byte 5 is the high byte of the length: the receiver waits for 256 bytes more, but not for ever.
TEST(EmulatedUblox, AQuestionWithADamagedLengthDoesNotHideTheNext) {
  UbloxHost host(UbloxModel::m8);
  const auto dialogue = dialogue_of("m8");
  Frame damaged = dialogue.front().said;
  damaged.at(5) = 1;
  EXPECT_THAT(host.say(damaged), IsEmpty());
  host.now += std::chrono::seconds{1};
  EXPECT_EQ(host.say(dialogue.front().said), dialogue.front().answers);
}

TEST(EmulatedUblox, OnlySavedSettingsOutliveALossOfPower) {
  const auto memory = std::make_shared<Memory>();
  {
    UbloxHost host(UbloxModel::m8, 1, memory);
    EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, {0x01, 0x20, 5}));
    EXPECT_TRUE(host.acknowledges(ubx::cfg_cfg, {0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0, 0x17}));
    EXPECT_TRUE(host.acknowledges(ubx::cfg_rate, {200, 0, 1, 0, 0, 0}));
  }
  UbloxHost again(UbloxModel::m8, 1, memory);
  const auto rates = again.say(ubx::cfg_msg, {0x01, 0x20});
  EXPECT_EQ(rates.at(0)[6 + 3], 5);
  again.listen(4.5);
  EXPECT_EQ(again.all<wire::NavPvt>().size(), 5u) << "1 Hz, which was not lost";
}

TEST(EmulatedUblox, ASavedPeriodAndBaudRateAreThereAfterPower) {
  const auto memory = std::make_shared<Memory>();
  {
    UbloxHost host(UbloxModel::f9, 1, memory);
    // RATE-MEAS 200 and UART1-BAUDRATE 115200 in flash only.
    EXPECT_TRUE(
        host.acknowledges(ubx::cfg_valset, {0, 4, 0, 0, 0x01, 0x00, 0x21, 0x30, 200, 0,  //
                                            0x01, 0x00, 0x52, 0x40, 0x00, 0xC2, 0x01, 0x00}));
    EXPECT_THAT(host.bauds, ElementsAre(38400));
  }
  UbloxHost again(UbloxModel::f9, 1, memory);
  again.listen(1.9);
  EXPECT_THAT(again.bauds, ElementsAre(115200));
  EXPECT_EQ(again.all<wire::NavPvt>().size(), 10u);
}

// The keys CFG-SIGNAL-* with which an autopilot sets up the bands of an F9, GPS and SBAS on and
// Galileo off: one transaction, all or nothing.
TEST(EmulatedUblox, AnF9TakesTheBandsOfAnAutopilotInOneSetting) {
  UbloxHost host(UbloxModel::f9);
  Frame bands{0, 1, 0, 0};
  for (const auto& [key, value] : std::vector<std::pair<std::uint8_t, std::uint8_t>>{
           {0x1F, 1}, {0x01, 1}, {0x03, 1}, {0x20, 1}, {0x05, 1}, {0x21, 0}, {0x07, 0}, {0x0A, 0}})
    bands.insert(bands.end(), {key, 0x00, 0x31, 0x10, value});
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, bands));
  const auto answer = host.say(ubx::cfg_valget, {0, 0, 0, 0, 0x05, 0x00, 0x31, 0x10}).at(0);
  EXPECT_EQ(ubx::packet_of(answer).payload.back(), 1);
}

TEST(EmulatedUblox, TellsWhatItWasToldAndWhatItRefused) {
  UbloxHost host(UbloxModel::m8);
  host.say(ubx::cfg_rate, {200, 0, 1, 0, 0, 0});
  host.say(ubx::cfg_rate, {200, 0, 1, 0, 0, 0});
  host.say(ubx::cfg_msg, {0x01, 0x20, 5});
  host.say(0x063B, {1});
  EXPECT_THAT(host.told, ElementsAre("CFG-RATE: an epoch each 200 ms",
                                     "CFG-MSG: NAV-TIMEGPS each 5 epochs", "refused CFG-PM2"));
}

/// The order in which ArduSub 4.7 sets up a receiver that it takes for an M8.
TEST(EmulatedUblox, TheSequenceOfAnAutopilotEndsWithAConfiguredReceiverAt230400) {
  UbloxHost host(UbloxModel::m8, 1);
  const auto polls = [&](std::uint16_t id, const Frame& payload, std::size_t bytes) {
    const auto answers = host.say(id, payload);
    ASSERT_EQ(answers.size(), 2u) << std::hex << id;
    EXPECT_EQ(ubx::packet_of(answers[0]).class_and_id, id);
    EXPECT_EQ(ubx::packet_of(answers[0]).payload.size(), bytes);
    EXPECT_EQ(ubx::packet_of(answers[1]).class_and_id, ubx::ack_ack);
  };
  const std::string rate_change = "$PUBX,41,1,0023,0001,230400,0*1E\r\n";
  host.say(Frame(rate_change.begin(), rate_change.end()));
  EXPECT_EQ(host.bauds.back(), 230400u);
  polls(ubx::cfg_prt, {}, 20);
  for (const auto& [cls, id] : std::vector<std::pair<std::uint8_t, std::uint8_t>>{{0x01, 0x07},
                                                                                  {0x01, 0x06},
                                                                                  {0x01, 0x03},
                                                                                  {0x01, 0x02},
                                                                                  {0x01, 0x12},
                                                                                  {0x01, 0x20},
                                                                                  {0x01, 0x04},
                                                                                  {0x0A, 0x09},
                                                                                  {0x0A, 0x0B},
                                                                                  {0x0D, 0x03}})
    polls(ubx::cfg_msg, {cls, id}, 8);
  for (const Frame& set :
       {Frame{0x01, 0x07, 1}, Frame{0x01, 0x20, 5}, Frame{0x01, 0x04, 5}, Frame{0x0A, 0x09, 5},
        Frame{0x0A, 0x0B, 5}, Frame{0x0D, 0x03, 1}, Frame{0x01, 0x61, 0}, Frame{0x01, 0x35, 0}})
    EXPECT_TRUE(host.acknowledges(ubx::cfg_msg, set));
  polls(ubx::cfg_rate, {}, 6);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_rate, {200, 0, 1, 0, 0, 0}));
  EXPECT_EQ(host.say(0x0130).size(), 1u);
  polls(ubx::cfg_nav5, {}, 36);
  Frame nav5(36, 0);
  nav5[0] = 1;
  nav5[2] = 8;
  EXPECT_TRUE(host.acknowledges(ubx::cfg_nav5, nav5));
  polls(ubx::cfg_gnss, {}, 4 + 8 * 6);
  EXPECT_EQ(host.say(ubx::mon_ver).size(), 1u);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_cfg, {0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0}));
  host.listen(1.9);
  EXPECT_EQ(host.count(0x0107), 10u);
  EXPECT_EQ(host.count(0x0120), 2u);
  EXPECT_EQ(host.count(0x0135), 0u);
}

/// CFG-VALSET to RAM of keys and values, each of the size that its key says.
Frame valset(std::initializer_list<std::pair<std::uint32_t, std::uint32_t>> items) {
  Frame payload{0, 1, 0, 0};
  for (const auto& [key, value] : items) {
    for (int i = 0; i < 4; ++i) payload.push_back(static_cast<std::uint8_t>(key >> 8 * i));
    const unsigned size = key >> 28 == 4 ? 4 : key >> 28 == 3 ? 2 : 1;
    for (unsigned i = 0; i < size; ++i)
      payload.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  }
  return payload;
}

/// The settings with which PX4's driver (PX4-GPSDrivers, ubx.cpp) sets up an F9: the form of the
/// port and its protocols, the navigation engine and the odometer, the messages, the other ports.
TEST(EmulatedUblox, AnF9TakesTheSettingsOfPx4) {
  UbloxHost host(UbloxModel::f9);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, valset({{0x20520002, 1},
                                                         {0x20520003, 0},
                                                         {0x20520004, 0},
                                                         {0x10730001, 1},
                                                         {0x10730002, 0},
                                                         {0x10740001, 1},
                                                         {0x10740002, 0}})));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, valset({{0x40520001, 115200}})));
  EXPECT_EQ(host.bauds.back(), 115200u);
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, valset({{0x10730004, 1},
                                                         {0x10770001, 1},
                                                         {0x10770004, 1},
                                                         {0x10770002, 0},
                                                         {0x10780001, 1},
                                                         {0x10780002, 0}})));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, valset({{0x20110011, 3},
                                                         {0x2011001C, 3},
                                                         {0x20110021, 7},
                                                         {0x10220001, 0},
                                                         {0x10220002, 0},
                                                         {0x10220003, 0},
                                                         {0x10220004, 0},
                                                         {0x1041000D, 1},
                                                         {0x30210001, 100},
                                                         {0x30210002, 1},
                                                         {0x20210003, 0}})));
  EXPECT_TRUE(host.acknowledges(ubx::cfg_valset, valset({{0x20910007, 1},
                                                         {0x20910039, 1},
                                                         {0x2091001B, 1},
                                                         {0x2091035A, 1},
                                                         {0x20910269, 1},
                                                         {0x20910034, 1},
                                                         {0x2091008E, 1}})));
  EXPECT_TRUE(host.acknowledges(
      ubx::cfg_valset,
      valset({{0x10710001, 1}, {0x10710004, 0}, {0x10720001, 1}, {0x10720004, 0}})));
  host.listen(1);
  EXPECT_EQ(host.count(0x0107), 11u) << "NAV-PVT each 100 ms";
}

TEST(EmulatedUblox, SaysWhichKeyItRefuses) {
  UbloxHost host(UbloxModel::f9);
  EXPECT_FALSE(host.acknowledges(ubx::cfg_valset, valset({{0x30210001, 100}, {0x2FFF0001, 1}})));
  EXPECT_FALSE(host.acknowledges(ubx::cfg_valset, valset({{0x20520003, 1}})));
  EXPECT_THAT(host.told, ElementsAre("refused CFG-VALSET: unknown key 2FFF0001h",
                                     "refused CFG-VALSET: key 20520003h cannot be 1"));
}

/// UBX-13003221, CFG-PRT: several configurations can be concatenated to one input message.
TEST(EmulatedUblox, TakesTheSettingsOfSeveralPortsInOneMessage) {
  UbloxHost host(UbloxModel::m8);
  const auto port = [](std::uint8_t number) {  // 8N1, 115200 baud, UBX and RTCM 3 in, UBX out
    return Frame{number, 0, 0, 0, 0xD0, 8, 0, 0, 0x00, 0xC2, 1, 0, 0x21, 0, 1, 0, 0, 0, 0, 0};
  };
  Frame both = port(1), wrong = port(1);
  const Frame usb = port(3), none = port(9);
  both.insert(both.end(), usb.begin(), usb.end());
  wrong.insert(wrong.end(), none.begin(), none.end());
  EXPECT_FALSE(host.acknowledges(ubx::cfg_prt, wrong));
  EXPECT_EQ(host.bauds.back(), 9600u) << "all of them or none";
  EXPECT_TRUE(host.acknowledges(ubx::cfg_prt, both));
  EXPECT_EQ(host.bauds.back(), 115200u);
}

/// Counts the frames that a driver's end decodes.
struct FarEnd {
  wire::Framer<wire::UbxNmea::max_frame> framer;
  std::vector<std::uint16_t> ids;
  void take(wire::Bytes bytes) {
    framer.feed(bytes, wire::UbxNmea::scan, [this](wire::Bytes frame, std::size_t) {
      ids.push_back(ubx::packet_of(frame).class_and_id);
    });
  }
};

TEST(EmulatedUblox, AfterAChangeOfTheBaudRateAHostThatKeepsItsOwnReadsGarbage) {
  const Frozen trajectory(at_the_surface());
  FarEnd far;
  EmulatedLine line(
      make_emulated_device(device(rig_config::DeviceKind::gnss, "ubx", 5), trajectory, 1).value(),
      115200, [&](wire::Bytes bytes, const Passage&) { far.take(bytes); });
  shell::Lockstep lockstep(start);
  lockstep.add(line);
  lockstep.run_until(at_s(0.5));
  EXPECT_EQ(far.ids.size(), 9u) << "three epochs of three messages";
  far.ids.clear();
  // CFG-PRT of UART1 with 8N1, UBX in and out, 9600 baud.
  const Frame payload{1, 0, 0, 0, 0xD0, 8, 0, 0, 0x80, 0x25, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0};
  std::array<std::uint8_t, 64> frame;
  const wire::Bytes set = wire::Bytes{frame}.first(ubx::encode_frame(ubx::cfg_prt, payload, frame));
  line.receive(set, at_s(0.5));
  lockstep.run_until(at_s(3));
  EXPECT_THAT(far.ids, ElementsAre(ubx::ack_ack)) << "the acknowledgement at the old rate";
  EXPECT_GT(far.framer.counters().bytes_skipped, 100u);
  line.receive(set, at_s(3));
  lockstep.run_until(at_s(4));
  EXPECT_EQ(far.ids.size(), 1u) << "it does not hear 115200 any more";
}

}  // namespace ublox_dialogue_test
}  // namespace drydock::emulate
