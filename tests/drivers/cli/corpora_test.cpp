#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "tests/drivers/cli/captured.hpp"

/// `decode` against counts that other, simpler means give: a scanner of a few lines that knows
/// checksums only, or the output of somebody else's decoder.
namespace drydock::cli {
namespace corpora_test {

namespace fs = std::filesystem;
using Counts = std::map<std::string, int>;
using nlohmann::json;

class Corpora : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("DRYDOCK_CORPORA");
    root_ = named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
    if (!fs::exists(root_)) GTEST_SKIP() << "no captures in " << root_;
  }
  std::vector<fs::path> files(const char* folder, const char* extension) const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(root_ / folder))
      if (entry.path().extension() == extension) found.push_back(entry.path());
    return found;
  }
  fs::path root_;
};

Counts decoded_counts(const std::string& protocol, const fs::path& file) {
  Counts counts;
  for (const json& line : run_decode({protocol, file.string(), true, true}).lines())
    counts[line["type"]] = line["count"];
  return counts;
}

Counts decoded_lines(const std::string& protocol, const fs::path& file) {
  Counts counts;
  for (const json& line : run_decode({protocol, file.string(), false, true}).lines())
    ++counts[line["type"]];
  return counts;
}

/// What the receiver said: gpsd's logs begin with lines of '#', some with sentences in them.
std::string recorded_by(const fs::path& log) {
  std::string text = read_file(log);
  while (text.starts_with('#')) text.erase(0, text.find('\n') + 1);
  return text;
}

/// Every `$ttsss,...*hh` with a good XOR and one of our formatters.
Counts scan_nmea(const std::string& text) {
  static const std::set<std::string> ours{"GGA", "RMC", "GSV", "GSA", "VTG", "ZDA", "GNS",
                                          "GLL", "GST", "HDT", "THS", "VHW", "VBW", "VLW"};
  Counts counts;
  for (auto at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1)) {
    int sum = 0;
    auto i = at + 1;
    for (; i < text.size() && text[i] >= ' ' && text[i] <= '~' && text[i] != '*' && text[i] != '$';
         ++i)
      sum ^= text[i];
    if (i + 2 >= text.size() || text[i] != '*') continue;
    const std::string hex = text.substr(i + 1, 2);
    if (!std::isxdigit(static_cast<unsigned char>(hex[0])) ||
        !std::isxdigit(static_cast<unsigned char>(hex[1])) || std::stoi(hex, nullptr, 16) != sum)
      continue;
    const std::string address = text.substr(at + 1, text.find_first_of(",*", at) - at - 1);
    if (address.size() == 5 && ours.contains(address.substr(2))) ++counts[address.substr(2)];
  }
  return counts;
}

/// Every message of ours with a good Fletcher checksum.
Counts scan_ubx(const std::string& text) {
  static const std::map<int, std::string> ours{
      {0x0102, "NAV-POSLLH"},  {0x0103, "NAV-STATUS"},  {0x0104, "NAV-DOP"},
      {0x0106, "NAV-SOL"},     {0x0107, "NAV-PVT"},     {0x0112, "NAV-VELNED"},
      {0x0120, "NAV-TIMEGPS"}, {0x0121, "NAV-TIMEUTC"}, {0x0130, "NAV-SVINFO"},
      {0x0135, "NAV-SAT"},     {0x0143, "NAV-SIG"},     {0x0161, "NAV-EOE"},
      {0x0213, "RXM-SFRBX"},   {0x0215, "RXM-RAWX"}};
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  Counts counts;
  std::size_t at = 0;
  while ((at = text.find("\xB5"
                         "b",
                         at)) != std::string::npos &&
         at + 8 <= text.size()) {
    const std::size_t end = at + 6 + (byte(at + 4) | byte(at + 5) << 8);
    std::uint8_t a = 0, b = 0;
    for (std::size_t i = at + 2; i < end && i < text.size(); ++i) b += a += byte(i);
    if (end + 2 > text.size() || byte(end) != a || byte(end + 1) != b) {
      ++at;
      continue;
    }
    const auto known = ours.find(byte(at + 2) << 8 | byte(at + 3));
    if (known != ours.end()) ++counts[known->second];
    at = end + 2;
  }
  return counts;
}

/// Every 7F 7F with a length and a good sum.
int scan_pd0(const std::string& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  int count = 0;
  std::size_t at = 0;
  while ((at = text.find("\x7F\x7F", at)) != std::string::npos && at + 4 <= text.size()) {
    const std::size_t end = at + (byte(at + 2) | byte(at + 3) << 8);
    std::uint16_t sum = 0;
    for (std::size_t i = at; i < end && i < text.size(); ++i) sum += byte(i);
    const bool good =
        end > at + 6 && end + 2 <= text.size() && sum == (byte(end) | byte(end + 1) << 8);
    count += good;
    at = good ? end + 2 : at + 1;
  }
  return count;
}

TEST_F(Corpora, EveryGoodNmeaSentenceOfOursIsDecoded) {
  Counts all;
  for (const fs::path& file : files("gps/gpsd/daemon", ".log")) {
    const Counts expected = scan_nmea(recorded_by(file));
    EXPECT_EQ(decoded_counts("nmea0183", file), expected) << file;
    for (const auto& [type, count] : expected) all[type] += count;
  }
  for (const char* type :
       {"GGA", "RMC", "GSV", "GSA", "VTG", "ZDA", "GNS", "GLL", "GST", "VHW", "VLW"})
    EXPECT_GT(all[type], 50) << type;
}

TEST_F(Corpora, EveryGoodUbxMessageOfOursIsDecoded) {
  Counts all;
  for (const char* folder : {"gps/gpsd/daemon", "gps/pyubx2"})
    for (const fs::path& file : files(folder, ".log")) {
      const Counts expected = scan_ubx(recorded_by(file));
      EXPECT_EQ(decoded_counts("ubx", file), expected) << file;
      for (const auto& [type, count] : expected) all[type] += count;
    }
  EXPECT_GT(all["NAV-PVT"], 400);
  EXPECT_GT(all["NAV-SAT"], 300);
  EXPECT_GT(all["NAV-EOE"], 300);
  EXPECT_GT(all["NAV-DOP"], 600);
  EXPECT_GT(all["RXM-SFRBX"], 800);
  EXPECT_EQ(all["RXM-RAWX"], 14);
}

TEST_F(Corpora, AMixedPortGivesBothProtocols) {
  const fs::path file = root_ / "gps/gpsd/daemon/ublox-neo-m8l.log";
  Counts expected = scan_ubx(recorded_by(file));
  expected.merge(scan_nmea(recorded_by(file)));
  EXPECT_EQ(decoded_lines("ubx+nmea0183", file), expected);
}

TEST_F(Corpora, EveryGoodPd0EnsembleIsDecoded) {
  // Ensembles that MHKiT-Python finds in the whole of each file.
  const std::map<std::string, int> mhkit{
      {"RDI_withBT.000", 1721}, {"winriver01.PD0", 262}, {"winriver02.PD0", 75}};
  for (const auto& entry : fs::directory_iterator(root_ / "dvl/pd0/raw")) {
    if (entry.path().extension() == ".json") continue;
    const int expected = scan_pd0(read_file(entry.path()));
    EXPECT_EQ(decoded_lines("pd0", entry.path()), (Counts{{"PD0", expected}})) << entry.path();
    if (const auto known = mhkit.find(entry.path().filename()); known != mhkit.end()) {
      EXPECT_EQ(expected, known->second) << entry.path();
    }
  }
}

TEST_F(Corpora, Pd0LeadersReadAsInMhkit) {
  const auto lines = run_decode({"pd0", root_ / "dvl/pd0/raw/RDI_withBT.000", false, true}).lines();
  std::istringstream rows(read_file(root_ / "dvl/pd0/expected/RDI_withBT.jsonl"));
  std::size_t row = 0;
  for (std::string text; std::getline(rows, text); ++row) {
    const json expected = json::parse(text);
    ASSERT_LT(row, lines.size());
    EXPECT_EQ(lines[row]["ensemble"], expected["number"]);
    EXPECT_NEAR(lines[row]["heading_deg"].get<double>(), expected["heading"].get<double>(), 2e-5);
    EXPECT_NEAR(lines[row]["pitch_deg"].get<double>(), expected["pitch"].get<double>(), 2e-5);
    EXPECT_NEAR(lines[row]["roll_deg"].get<double>(), expected["roll"].get<double>(), 2e-5);
    EXPECT_EQ(lines[row]["sound_speed_mps"], expected["c_sound"]);
  }
  EXPECT_GE(row, 100u);
}

TEST_F(Corpora, Pd0BottomVelocityIsMhkitsWithTheOtherSign) {
  const auto lines = run_decode({"pd0", root_ / "dvl/pd0/raw/winriver02.PD0", false, true}).lines();
  std::istringstream rows(read_file(root_ / "dvl/pd0/expected/winriver02.jsonl"));
  std::size_t row = 0, with_lock = 0;
  for (std::string text; std::getline(rows, text); ++row) {
    ASSERT_LT(row, lines.size());
    const json theirs = json::parse(text)["vel_bt"];  // of the bed, -32.768 where there is none
    for (std::size_t beam = 0; beam < 4; ++beam) {
      const json& velocity = lines[row]["bottom_velocity_mps"][beam];
      ASSERT_EQ(velocity.is_null(), theirs[beam].get<double>() < -32) << row;
      if (velocity.is_null()) continue;
      EXPECT_NEAR(velocity.get<double>(), -theirs[beam].get<double>(), 1e-6);
      ++with_lock;
    }
  }
  EXPECT_GT(with_lock, 100u);
}

/// What canboat's analyzer calls our NMEA 2000 messages.
const std::map<int, std::string> pgns{{128267, "water_depth"},    {130314, "pressure"},
                                      {130312, "temperature"},    {127245, "rudder"},
                                      {127488, "engine"},         {129029, "gnss_position"},
                                      {60928, "address_claimed"}, {59904, "request"}};

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

/// Single frames by their identifier; fast packets by parts that come in order from one source.
Counts scan_nmea2000(const std::string& log) {
  struct Assembly {
    int next = 0, missing = 0;
  };
  std::map<std::pair<int, int>, Assembly> assemblies;
  Counts counts;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const auto hash = line.find('#');
    if (line.empty() || line[0] != '(' || hash == std::string::npos) continue;
    const auto id = std::stoul(line.substr(line.rfind(' ', hash) + 1, hash), nullptr, 16);
    int pgn = static_cast<int>(id >> 8 & 0x3FFFF);
    if ((pgn >> 8 & 0xFF) < 240) pgn &= 0x3FF00;
    if (!pgns.contains(pgn)) continue;
    if (pgn != 129029) {
      ++counts[pgns.at(pgn)];
      continue;
    }
    const int first = std::stoi(line.substr(hash + 1, 2), nullptr, 16);
    Assembly& assembly = assemblies[{static_cast<int>(id & 0xFF), first >> 5}];
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

}  // namespace corpora_test
}  // namespace drydock::cli
