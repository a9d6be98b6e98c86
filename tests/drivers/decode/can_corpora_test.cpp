// Compares CAN logs with canboat's analyzer, a scanner of identifiers, and a vendor's formula.
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/drivers/decode/corpora.hpp"

namespace drydock::decode {
namespace can_corpora_test {

using namespace corpora;

/// Our names for the NMEA 2000 messages, by the PGN that canboat's analyzer prints.
const std::map<int, std::string> pgns{{128267, "water_depth"},     {130314, "pressure"},
                                      {130312, "temperature"},     {127245, "rudder"},
                                      {127488, "engine"},          {129029, "gnss_position"},
                                      {60928, "address_claimed"},  {59904, "request"},
                                      {127237, "heading_control"}, {127250, "vessel_heading"},
                                      {127251, "turn_rate"},       {127252, "heave"},
                                      {127257, "attitude"},        {127258, "magnetic_variation"},
                                      {128259, "speed"},           {128275, "distance_log"},
                                      {129025, "rapid_position"},  {129026, "course_and_speed"},
                                      {129539, "dilutions"},       {129540, "satellites_in_view"},
                                      {130310, "water_and_air"},   {130311, "environment"},
                                      {126992, "system_time"}};
const std::set<int> fast_packets{127237, 128275, 129029, 129540};

TEST_F(Corpora, Nmea2000MessagesAreThoseThatCanboatFinds) {
  Counts expected;
  std::vector<double> depths;
  std::istringstream rows(read_file(root_ / "n2k/canboat/expected/candumpSample3.txt.json"));
  for (std::string text; std::getline(rows, text);) {
    const json row = json::parse(text);
    if (!row.contains("pgn") || !pgns.contains(row["pgn"])) continue;
    ++expected[pgns.at(row["pgn"])];
    if (row["pgn"] == 128267) depths.push_back(row["fields"]["Depth"]);
  }
  const fs::path sample = root_ / "n2k/canboat/samples/candumpSample3.txt";
  EXPECT_EQ(decoded_lines("nmea2000", sample), expected);
  std::vector<double> decoded;
  for (const json& line : run_decode({"nmea2000", sample.string(), false, true}).lines())
    if (line["type"] == "water_depth") decoded.push_back(line["depth_m"]);
  EXPECT_THAT(decoded, testing::Pointwise(testing::DoubleNear(1e-9), depths));
  EXPECT_EQ(depths.size(), 17u);
}

/// Counts single frames by their identifier, and fast packets by parts that come in order from one
/// source.
Counts scan_nmea2000(const std::string& log) {
  struct Assembly {
    int next = 0, missing = 0;
  };
  std::map<std::tuple<int, int, int>, Assembly> assemblies;
  Counts counts;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const auto hash = line.find('#');
    if (line.empty() || line[0] != '(' || hash == std::string::npos) continue;
    const auto id = std::stoul(line.substr(line.rfind(' ', hash) + 1, hash), nullptr, 16);
    int pgn = static_cast<int>(id >> 8 & 0x3FFFF);
    if ((pgn >> 8 & 0xFF) < 240) pgn &= 0x3FF00;
    if (!pgns.contains(pgn)) continue;
    if (!fast_packets.contains(pgn)) {
      ++counts[pgns.at(pgn)];
      continue;
    }
    const int first = std::stoi(line.substr(hash + 1, 2), nullptr, 16);
    Assembly& assembly = assemblies[{pgn, static_cast<int>(id & 0xFF), first >> 5}];
    if ((first & 31) == 0)
      assembly = {1, std::stoi(line.substr(hash + 3, 2), nullptr, 16) - 6};
    else if ((first & 31) == assembly.next)
      ++assembly.next, assembly.missing -= 7;
    else
      assembly = {};
    if (assembly.next > 0 && assembly.missing <= 0) ++counts[pgns.at(pgn)], assembly = {};
  }
  return counts;
}

TEST_F(Corpora, EveryNmea2000MessageOfOursInARealLogIsDecoded) {
  const fs::path file = root_ / "n2k/gpsd/logfile_20140914_365495765_can.log";
  const Counts expected = scan_nmea2000(read_file(file));
  EXPECT_EQ(decoded_lines("nmea2000", file), expected);
  EXPECT_EQ(expected.at("water_depth"), 198);
  EXPECT_GT(expected.at("gnss_position"), 100);
}

TEST_F(Corpora, AceinnaFramesReadAsTheVendorsFormulaSays) {
  const fs::path log = root_ / "can_imu/aceinna_mtlt_real.candump.log";
  std::vector<json> lines;
  for (const json& line : run_decode({"aceinna", log.string(), false, true}).lines())
    if (line["type"] != "request" && line["type"] != "software_bit") lines.push_back(line);
  std::istringstream rows(read_file(root_ / "can_imu/aceinna_mtlt_real.expected.jsonl"));
  std::size_t at = 0;
  for (std::string text; std::getline(rows, text);) {
    const json row = json::parse(text);
    if (row["pgn"] == 61481) {
      ASSERT_LT(at, lines.size());
      EXPECT_EQ(lines[at]["type"], "slope_sensor");
      EXPECT_NEAR(lines[at]["pitch_deg"].get<double>(), row["pitch_deg"].get<double>(), 1e-9);
      EXPECT_NEAR(lines[at]["roll_deg"].get<double>(), row["roll_deg"].get<double>(), 1e-9);
      EXPECT_NEAR(lines[at++]["latency_s"].get<double>(), row["latency_ms"].get<double>() / 1e3,
                  1e-12);
    } else if (row["pgn"] == 61485) {
      ASSERT_LT(at, lines.size());
      EXPECT_EQ(lines[at]["type"], "acceleration");
      EXPECT_NEAR(lines[at]["acceleration_x_mps2"].get<double>(), row["acc_ms2"][0].get<double>(),
                  1e-9);
      EXPECT_NEAR(lines[at]["acceleration_y_mps2"].get<double>(), row["acc_ms2"][1].get<double>(),
                  1e-9);
      EXPECT_NEAR(lines[at++]["acceleration_z_mps2"].get<double>(), row["acc_ms2"][2].get<double>(),
                  1e-9);
    } else if (row["pgn"] == 61482) {
      ASSERT_LT(at, lines.size());
      EXPECT_EQ(lines[at]["type"], "angular_rate");
      EXPECT_NEAR(lines[at]["rate_x_degps"].get<double>(), row["rate_dps"][0].get<double>(), 1e-9);
      EXPECT_NEAR(lines[at]["rate_y_degps"].get<double>(), row["rate_dps"][1].get<double>(), 1e-9);
      EXPECT_NEAR(lines[at++]["rate_z_degps"].get<double>(), row["rate_dps"][2].get<double>(),
                  1e-9);
    }
  }
  EXPECT_EQ(at, lines.size());
  EXPECT_GE(at, 12u);
}

}  // namespace can_corpora_test
}  // namespace drydock::decode
