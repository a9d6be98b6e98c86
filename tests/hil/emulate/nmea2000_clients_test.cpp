#include "tests/hil/emulate/nmea2000_client.hpp"
#include "tests/npm/node.hpp"

/// What clients of other makers set in an emulated NMEA 2000 device by group functions (PGN
/// 126208). Layouts and error codes: canboat's database of PGNs.
namespace drydock::emulate {
namespace nmea2000_clients_test {

namespace j1939 = wire::j1939;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

/// The times at which frames of a PGN came until a time.
std::vector<double> times_of(SpeedLog& log, std::uint32_t pgn, double until_s) {
  log.sent.frames.clear();
  log.sent.run(*log.node, at_s(until_s));
  std::vector<double> times;
  for (const auto& [at, frame] : log.sent.frames)
    if (j1939::identify(frame)->pgn == pgn)
      times.push_back(std::chrono::duration<double>(at - start).count());
  return times;
}

Data timed(std::uint32_t pgn, std::uint32_t interval_ms, std::uint16_t offset_10ms) {
  Data message = request(pgn, interval_ms);
  wire::store_le<std::uint16_t>(message, 8, offset_10ms);
  return message;
}

TEST(Nmea2000Clients, APgnComesAtTheIntervalAndOffsetThatAClientGives) {
  SpeedLog log(10);
  EXPECT_EQ(times_of(log, speed, 1.95).size(), 9u);
  log.tell(timed(speed, 500, 20));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x03, 0xF5, 0x01, 0x00, 0)));
  EXPECT_THAT(times_of(log, speed, 4.05),
              ElementsAre(testing::DoubleNear(2.2, 1e-6), testing::DoubleNear(2.7, 1e-6),
                          testing::DoubleNear(3.2, 1e-6), testing::DoubleNear(3.7, 1e-6)));
  log.tell(timed(speed, 0, 0xFFFF));
  EXPECT_THAT(times_of(log, speed, 6), IsEmpty()) << "0: never";
  log.tell(timed(speed, default_interval, 0xFFFF));
  EXPECT_EQ(times_of(log, speed, 6.95).size(), 9u);
  log.tell(timed(speed, 50, 0xFFFF));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x03, 0xF5, 0x01, 0x20, 0)));
  EXPECT_THAT(
      log.sent.told,
      ElementsAre("interval of PGN 128259: 500 ms", "interval of PGN 128259: never",
                  "interval of PGN 128259: as delivered", "refused interval of PGN 128259: 50 ms"));
}

/// 128275 travels in several frames, once a second.
TEST(Nmea2000Clients, AMessageOfManyFramesComesWholeOrNotAtAll) {
  constexpr std::uint32_t distance = 128275;
  SpeedLog log(10);
  const auto usual = times_of(log, distance, 10.5).size();
  EXPECT_EQ(usual, 10u * 3) << "16 bytes: three frames";
  log.tell(timed(distance, 500, 0xFFFF));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x13, 0xF5, 0x01, 0x20, 0)));
  log.tell(timed(distance, 3000, 0xFFFF));
  EXPECT_EQ(times_of(log, distance, 19.5).size(), 3u * 3);
}

TEST(Nmea2000Clients, TheHeartbeatBeginsAtItsOffset) {
  SpeedLog log;
  log.tell(timed(heartbeat, 10000, 150));
  EXPECT_THAT(times_of(log, heartbeat, 22), ElementsAre(2.5, 12.5));
}

TEST(Nmea2000Clients, APriorityIsThatOfTheClient) {
  SpeedLog log(10);
  const auto priority = [&](double until_s) {
    const auto times = times_of(log, speed, until_s);
    for (const auto& [at, frame] : log.sent.frames)
      if (j1939::identify(frame)->pgn == speed) return int{j1939::identify(frame)->priority};
    return -1;
  };
  const int usual = priority(1.95);
  log.tell({1, 0x03, 0xF5, 0x01, 0xF5, 0});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x03, 0xF5, 0x01, 0x00, 0)));
  EXPECT_EQ(priority(2.95), 5);
  log.tell({1, 0x03, 0xF5, 0x01, 0xF9, 0});
  EXPECT_EQ(priority(3.95), usual);
}

/// Field 1: the identity number, 21 bits in three bytes.
TEST(Nmea2000Clients, ARequestIsAnsweredWhereItsValuesAreTheDevices) {
  SpeedLog log;
  log.sent.frames.clear();
  log.node->receive(j1939::encode(j1939::Request{client, log_address, name_pgn}), log.sent.now,
                    log.sent);
  const auto claimed = log.sent_of(name_pgn).at(0);
  Data asked = request(name_pgn, unchanged);
  asked[10] = 2;
  asked.insert(asked.end(), {1, claimed[0], claimed[1], std::uint8_t(claimed[2] & 0x1F), 5, 155});
  log.tell(asked);
  EXPECT_EQ(log.sent_of(name_pgn).size(), 1u);
  EXPECT_THAT(log.answers(), IsEmpty());
  asked.back() = 156;
  log.tell(asked);
  EXPECT_THAT(log.sent_of(name_pgn), IsEmpty());
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEE, 0x00, 0x00, 2, 0x30)));
  log.tell(asked, j1939::global_address);
  EXPECT_THAT(log.sent.frames, IsEmpty()) << "of another one";
}

/// After field 77, whose length nobody knows, nothing can be read.
TEST(Nmea2000Clients, FieldsThatAPgnDoesNotHaveAndValuesThatAreMissingAreInvalid) {
  SpeedLog log;
  Data asked = request(product, unchanged);
  asked[10] = 3;
  asked.insert(asked.end(), {8, 1, 77, 1, 2, 0, 0});
  log.tell(asked);
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x00, 3, 0x10, 0xF2)));
  EXPECT_THAT(log.sent.told, IsEmpty());
  asked[10] = 1;
  asked.resize(11);
  asked.insert(asked.end(), {1, 0x34});
  log.tell(asked);
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x00, 1, 0xF1)));
  EXPECT_THAT(
      log.sent.told,
      ElementsAre("a group function (126208) of PGN 126996 that ends before its last value"));
}

TEST(Nmea2000Clients, OnlyTheListThatAClientWantsIsSent) {
  SpeedLog log;
  Data asked = request(126464, unchanged);
  asked[10] = 1;
  asked.insert(asked.end(), {1, 1});
  log.tell(asked);
  const auto lists = log.sent_of(126464);
  ASSERT_EQ(lists.size(), 1u);
  EXPECT_EQ(lists[0][0], 1);
}

Data text_of_installation(const SpeedLog& log) { return log.sent_of(configuration).at(0); }

TEST(Nmea2000Clients, TheInstallationIsDescribedAndStaysSo) {
  const PowerUp power{start, std::make_shared<Condition>(), std::make_shared<Memory>()};
  const Data bow{5, 1, 'B', 'o', 'w'};
  {
    SpeedLog log(0.01, power);
    log.tell({1, 0x16, 0xF0, 0x01, 0xF8, 2, 2, 5, 1, 'B', 'o', 'w', 3, 3, 1, 'x'});
    EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x16, 0xF0, 0x01, 0x00, 2, 0x40)))
        << "the maker's words are not the client's";
    EXPECT_EQ(log.sent.told[0], "installation description 2: \"Bow\"");
    Data much{1, 0x16, 0xF0, 0x01, 0xF8, 1, 1, 73, 1};
    much.insert(much.end(), 71, 'a');
    log.tell(much);
    EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x16, 0xF0, 0x01, 0x00, 1, 0xF3)))
        << "more than 70 characters";
  }
  SpeedLog again(0.01, power);
  again.tell(request(configuration, unchanged));
  const Data told = text_of_installation(again);
  EXPECT_EQ(Data(told.begin(), told.begin() + 7), (Data{2, 1, 5, 1, 'B', 'o', 'w'}));
}

/// The NAME changes in its bits 32 to 39 and 56 to 59, and is claimed again.
TEST(Nmea2000Clients, InstancesAreThoseOfTheClient) {
  const PowerUp power{start, std::make_shared<Condition>(), std::make_shared<Memory>()};
  SpeedLog log(0.01, power);
  log.tell({1, 0x00, 0xEE, 0x00, 0xF8, 4, 3, 2, 4, 1, 8, 5, 5, 130});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEE, 0x00, 0x00, 4, 0x00, 0x40)));
  const auto claimed = log.sent_of(name_pgn);
  ASSERT_EQ(claimed.size(), 1u);
  EXPECT_EQ(claimed[0][4], 2 | 1 << 3);
  EXPECT_EQ(claimed[0][5], 155);
  EXPECT_EQ(claimed[0][7] & 0xF, 5);
  EXPECT_EQ(log.sent.told.back(), "device instance 10, system instance 5");
  SpeedLog again(0.01, power);
  EXPECT_EQ(again.sent_of(name_pgn).at(0), claimed[0]) << "also without power";
  again.tell({1, 0x00, 0xEE, 0x00, 0xF8, 1, 8, 16});
  EXPECT_THAT(again.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEE, 0x00, 0x00, 1, 0xF3)));
}

/// The same by canboatjs, which knows nothing of us.
TEST(Nmea2000Clients, CanboatsWordsAreObeyed) {
  DRYDOCK_NEEDS_NODE();
  const json asked = json::array({{{"functionCode", "Request"},
                                   {"pgn", 128259},
                                   {"transmissionInterval", 0.5},
                                   {"transmissionIntervalOffset", 0.2},
                                   {"numberOfParameters", 0},
                                   {"list", json::array()}},
                                  {{"functionCode", "Request"},
                                   {"pgn", 60928},
                                   {"numberOfParameters", 1},
                                   {"list", json::array({{{"parameter", 3}, {"value", 0}}})}},
                                  {{"functionCode", "Command"},
                                   {"pgn", 126998},
                                   {"priority", 8},
                                   {"numberOfParameters", 1},
                                   {"list", json::array({{{"parameter", 1}, {"value", "Keel"}}})}},
                                  {{"functionCode", "Command"},
                                   {"pgn", 60928},
                                   {"priority", 8},
                                   {"numberOfParameters", 2},
                                   {"list", json::array({{{"parameter", 3}, {"value", 2}},
                                                         {{"parameter", 8}, {"value", 5}}})}}});
  const auto words = test::run_node("tests/npm/ask_nmea2000.cjs", {}, asked.dump());
  ASSERT_EQ(words.size(), asked.size()) << words;
  SpeedLog log(10);
  log.tell(words[0].get<Data>());
  EXPECT_EQ(times_of(log, speed, 2.95).size(), 4u);
  log.tell(words[1].get<Data>());
  EXPECT_EQ(log.sent_of(name_pgn).size(), 1u);
  log.tell(words[2].get<Data>());
  log.tell(words[3].get<Data>());
  EXPECT_THAT(log.sent.told,
              ElementsAre("interval of PGN 128259: 500 ms", "installation description 1: \"Keel\"",
                          "device instance 2, system instance 5"));
}

}  // namespace nmea2000_clients_test
}  // namespace drydock::emulate
