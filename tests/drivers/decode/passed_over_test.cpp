// What a codec passes over is named and counted at the end: valid frames and blocks of every
// family.
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>

#include "drivers/wire/nmea2000/pgn_name.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/drivers/decode/corpora.hpp"
#include "tests/npm/node.hpp"

namespace drydock::decode {
namespace passed_over_test {

using corpora::Corpora;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

/// The names and counts behind the line "passed over:".
std::map<std::string, int> passed_over(const std::string& protocol, const std::string& bytes) {
  const TemporaryFile file(bytes);
  const Decoded decoded = run_decode({protocol, file.path(), true, false});
  std::map<std::string, int> counts;
  std::istringstream lines(
      decoded.err.substr(std::min(decoded.err.size(), decoded.err.find("passed over:\n"))));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    int count = 0;
    std::string name;
    words >> count >> std::ws;
    std::getline(words, name);
    counts[name] = count;
  }
  return counts;
}

/// `$body*hh`, with the XOR of all characters between.
std::string sentence(const std::string& body) {
  const unsigned sum = std::accumulate(body.begin(), body.end(), 0U, [](unsigned x, char c) {
    return x ^ static_cast<unsigned char>(c);
  });
  constexpr char digits[] = "0123456789ABCDEF";
  return "$" + body + "*" + digits[sum >> 4] + digits[sum & 15] + "\r\n";
}

TEST(PassedOver, SentencesAreNamedByTheirAddress) {
  EXPECT_THAT(
      passed_over("nmea0183", sentence("GPHDT,10.5,T") + sentence("IIMWV,1,R,2,N,A") +
                                  sentence("IIMWV,1,R,2,N,A") + sentence("PGRME,1,M,2,M,3,M")),
      ElementsAre(Pair("$IIMWV", 2), Pair("$PGRME", 1)));
  EXPECT_THAT(passed_over("nortek", sentence("PNORS4,23.6,1530.2,0.0,0.0,0.0,0.000,23.30")),
              ElementsAre(Pair("$PNORS4", 1)));
}

/// Class, id, length, payload and the two sums of u-blox's manual.
std::string ubx(unsigned char number, unsigned char id, const std::string& payload) {
  std::string checked{char(number), char(id), char(payload.size()), '\0'};
  checked += payload;
  unsigned char a = 0, b = 0;
  for (const char c : checked)
    b = static_cast<unsigned char>(b + (a = static_cast<unsigned char>(a + c)));
  return "\xB5\x62" + checked + char(a) + char(b);
}

TEST(PassedOver, UbxMessagesAreNamedAsUbloxNamesThem) {
  const std::string stream =
      ubx(0x0A, 0x09, "1234") + ubx(0x77, 0x01, "") + ubx(0x0A, 0x09, "5678");
  EXPECT_THAT(passed_over("ubx", stream), ElementsAre(Pair("UBX 77-01", 1), Pair("UBX MON-HW", 2)));
  EXPECT_THAT(passed_over("ubx", ubx(0x01, 0x09, "") + ubx(0x06, 0x06, "") + ubx(0x29, 0x09, "") +
                                     ubx(0x01, 0x7F, "")),
              ElementsAre(Pair("UBX CFG-DAT", 1), Pair("UBX NAV-7F", 1), Pair("UBX NAV-ODO", 1),
                          Pair("UBX NAV2-ODO", 1)));
}

/// can/sbgCan.dbc of the maker: every message has a name.
TEST_F(Corpora, FramesOfAnSbgAreNamedAsItsDbcFileNamesThem) {
  std::istringstream dbc(read_file(root_ / "dbc/files/sbgCan.dbc"));
  std::string log, line;
  std::set<std::string> names;
  while (std::getline(dbc, line)) {
    unsigned id = 0;
    char name[64] = {};
    if (std::sscanf(line.c_str(), "BO_ %u SBG_ECAN_MSG_%63[A-Z0-9_]", &id, name) != 2) continue;
    char frame[64];
    std::snprintf(frame, sizeof frame, "(1.0) can0 %03X#00\n", id);
    log += frame;
    names.insert(name);
  }
  const auto counts = passed_over("sbg", log);
  EXPECT_GT(names.size(), 60u);
  std::size_t unread = 0;
  for (const auto& [name, count] : counts) {
    unread += static_cast<std::size_t>(count);
    EXPECT_EQ(names.count(name.substr(name.rfind(' ') + 1)), 1u) << name;
  }
  EXPECT_GT(unread, 50u);
}

TEST(PassedOver, ALineOfUbxAndNmeaNamesBoth) {
  EXPECT_THAT(passed_over("ubx+nmea0183", ubx(0x0A, 0x09, "") + sentence("GNGRS,1")),
              ElementsAre(Pair("$GNGRS", 1), Pair("UBX MON-HW", 1)));
}

/// 7F 7F, length, number of data types, their offsets, the data types, the sum of all bytes.
std::string pd0(const std::vector<std::string>& blocks) {
  const auto put = [](std::string& to, std::size_t value) {
    to += char(value & 0xFF);
    to += char(value >> 8);
  };
  std::string table, data;
  for (const std::string& block : blocks) {
    put(table, 6 + 2 * blocks.size() + data.size());
    data += block;
  }
  std::string frame = "\x7F\x7F";
  put(frame, 6 + table.size() + data.size());
  frame += '\0';
  frame += char(blocks.size());
  frame += table + data;
  std::size_t sum = 0;
  for (const char c : frame) sum += static_cast<unsigned char>(c);
  put(frame, sum & 0xFFFF);
  return frame;
}

TEST(PassedOver, DataTypesOfAnEnsembleAreNamedByTheirId) {
  const std::string ensemble = pd0({std::string("\x00\x01", 2) + std::string(30, 'v'),
                                    std::string("\x00\x30", 2) + std::string(10, 'a')});
  EXPECT_THAT(passed_over("pd0", ensemble + ensemble),
              ElementsAre(Pair("block 0100 velocity profile", 2), Pair("block 3000", 2),
                          Pair("frame of 56 bytes", 2)));
}

/// README.md of the dive: the vehicle's navigation is in data type 0x2000 of each of the 1934
/// ensembles, in an order of its own. It is read, so only the profiles are left.
TEST_F(Corpora, TheNavigationOfAnAuvInItsEnsemblesIsNotPassedOver) {
  const auto counts = passed_over("pd0", read_file(root_ / "dvl/pd0/raw/remus_20141219_a.adc"));
  EXPECT_THAT(counts, ElementsAre(Pair("block 0100 velocity profile", 1934),
                                  Pair("block 0200 correlation profile", 1934),
                                  Pair("block 0300 echo intensity profile", 1934),
                                  Pair("block 0400 percent good profile", 1934)));
}

/// SOURCES.md of the captures: the boat's GPS is in the data types 2022, 2101 and 2102. All are
/// read, so only the profiles of the 580 ensembles are left.
TEST_F(Corpora, TheSentencesOfWinRiverInEnsemblesAreNotPassedOver) {
  const auto counts = passed_over(
      "pd0", read_file(root_ / "dvl/pd0/raw/tanana_transects_08_10_10_0_002_10-08-10_142214.PD0"));
  EXPECT_THAT(counts, ElementsAre(Pair("block 0100 velocity profile", 580),
                                  Pair("block 0200 correlation profile", 580),
                                  Pair("block 0300 echo intensity profile", 580),
                                  Pair("block 0400 percent good profile", 580)));
}

TEST(PassedOver, PgnsAreNamedWithNumberAndSubject) {
  const std::string log =
      "(1.0) can0 09FD0223#FF1B010CFFFAFFFF\n"  // 130306
      "(1.1) can0 18FF5123#0102030405060708\n"  // 65361
      "(1.2) can0 0DFD5A23#0102030405060708\n"  // 130394, of which nothing is known here
      "(1.3) can0 09F11223#FF4BEDFF7FFF7FFD\n"  // 127250 is read
      "(1.4) can0 123#01\n";
  EXPECT_THAT(passed_over("nmea2000", log),
              ElementsAre(Pair("PGN 130306 wind", 1), Pair("PGN 130394", 1),
                          Pair("PGN 65361 proprietary", 1), Pair("identifier 123", 1)));
  EXPECT_THAT(
      passed_over("aceinna", log),
      ElementsAre(Pair("PGN 127250 heading", 1), Pair("PGN 130306 wind", 1), Pair("PGN 130394", 1),
                  Pair("PGN 65361 proprietary", 1), Pair("identifier 123", 1)));
}

/// SAE J1939-71 and -73.
TEST(PassedOver, ParameterGroupsOfJ1939AreNamed) {
  const std::string log =
      "(1.0) can0 0CF00400#0102030405060708\n"
      "(1.1) can0 18FECA00#0102030405060708\n"
      "(1.2) can0 18FDC500#0102030405060708\n";
  EXPECT_THAT(
      passed_over("microstrain-mv5", log),
      ElementsAre(Pair("PGN 61444 engine controller 1", 1), Pair("PGN 64965 ECU identification", 1),
                  Pair("PGN 65226 active trouble codes", 1)));
}

TEST(PassedOver, FramesOfOtherNetworksAreNamedByIdentifier) {
  const std::string log =
      "(1.0) can0 7E5#\n(1.1) can0 20000004#0004\n(1.2) can0 199#R8\n(1.3) can0 080#\n"
      "(1.4) can0 2FF#00\n(1.5) can0 605#4018100100000000\n(1.6) can0 6FF#00\n";
  EXPECT_THAT(
      passed_over("cia404-pressure", log),
      ElementsAre(Pair("error frame", 1), Pair("identifier 080 SYNC", 1),
                  Pair("identifier 2FF TPDO2 of node 127", 1),
                  Pair("identifier 605 SDO request of node 5", 1), Pair("identifier 6FF", 1),
                  Pair("identifier 7E5 LSS", 1), Pair("request for identifier 199", 1)));
  EXPECT_THAT(passed_over("xsens", "(1.0) can0 7E5#00\n"), ElementsAre(Pair("identifier 7E5", 1)));
}

TEST(PassedOver, WithoutAnythingNothingIsSaid) {
  EXPECT_THAT(passed_over("can", "(1.0) can0 123#01\n"), IsEmpty());
  EXPECT_THAT(passed_over("nmea0183", sentence("GPHDT,10.5,T")), IsEmpty());
}

TEST_F(Corpora, WhatIsPassedOverOfARealBusIsTheRestOfWhatCanboatNames) {
  const std::string log = read_file(root_ / "n2k/canboat/samples/candumpSample3.txt");
  const auto counts = passed_over("nmea2000", log);
  // Single frames of canboat's expected messages of these PGNs.
  EXPECT_EQ(counts.at("PGN 65359 proprietary"), 174);
  EXPECT_EQ(counts.at("PGN 130306 wind"), 18);
  EXPECT_EQ(counts.at("PGN 65379 proprietary"), 17);
  EXPECT_EQ(counts.count("PGN 127250"), 0U);
}

/// canboat's database has 337 PGNs that are not the fallback of a range.
TEST(PassedOver, EveryPgnOfCanboatsDatabaseHasAName) {
  DRYDOCK_NEEDS_NODE();
  const auto database = nlohmann::json::parse(
      read_file(DRYDOCK_SOURCE_DIR "/build/npm/node_modules/@canboat/ts-pgns/canboat.json"));
  std::size_t checked = 0;
  for (const auto& pgn : database["PGNs"]) {
    if (pgn.value("Fallback", false)) continue;
    EXPECT_FALSE(wire::nmea2000::pgn_name(pgn["PGN"]).empty())
        << pgn["PGN"] << " " << pgn["Description"];
    ++checked;
  }
  EXPECT_GT(checked, 300U);
}

}  // namespace passed_over_test
}  // namespace drydock::decode
