#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <fstream>

#include "tests/conformance/small_corpus.hpp"

/// Each format of expected values is read, and an error in it is seen.
namespace drydock::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Scoreboard, ADamagedVectorMustBeRefusedAndASoundOneRead) {
  const std::string head = "checksum\tkind\tsource\tsentence\tnote\n";
  write("eml/made.tsv",
        head + "ok\t\t\t$HCVHW,,,,,0.2,N,0,K*5B\t\n" + "BAD\t\t\t$HCVHW,,,,,0.2,N,0,K*5C\t\n");
  EXPECT_TRUE(only().clean());
  write("eml/made.tsv", head + "BAD\t\t\t$HCVHW,,,,,0.2,N,0,K*5B\t\n");
  EXPECT_EQ(only().counts().wrong, 1u) << "a sound sentence cannot be refused";
  write("eml/made.tsv", head + "ok\t\t\t$HCVHW,,,,,0.2,N,0,K*5C\t\n");
  EXPECT_EQ(only().counts().missed, 1u) << "a damaged sentence cannot be read";
}

TEST_F(Scoreboard, ASignalOfADbcFileThatReadsDifferentlyIsWrong) {
  write("dbc/files/made.dbc",
        "VERSION \"\"\nBU_: a\nBO_ 100 m: 2 a\n SG_ s : 0|16@1+ (0.5,1) [0|0] \"\" a\n");
  const auto line = [](const std::string& value, const std::string& id = "100") {
    return "{\"id\":" + id +
           ",\"ext\":false,\"msg\":\"m\",\"data\":\"0400\",\"sig\":{\"s\":{\"val\":" + value +
           "}}}\n";
  };
  write("dbc/expected/made.jsonl", line("3"));
  EXPECT_TRUE(only().clean());
  EXPECT_EQ(only().counts().by_value, 1u);
  write("dbc/expected/made.jsonl", line("3") + line("3.5"));
  EXPECT_EQ(only().counts().wrong, 1u);
  write("dbc/expected/made.jsonl", line("3", "101"));
  EXPECT_EQ(only().counts().missed, 1u) << "no message of this identifier";
  write("dbc/expected/lost.jsonl", line("3"));
  EXPECT_THAT(only().errors(), ElementsAre(HasSubstr("lost.jsonl")));
}

/// `$body*hh CR LF`
std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  std::array<char, 3> hex{};
  std::snprintf(hex.data(), hex.size(), "%02X", sum);
  return "$" + body + "*" + hex.data() + "\r\n";
}

std::string report_of(const char* time, const char* latitude) {
  return std::string(R"({"class":"TPV","mode":3,"time":"2018-08-20T)") + time + R"(Z","lat":)" +
         latitude + R"(,"lon":5.313616667})" + "\n";
}

TEST_F(Scoreboard, APositionThatGpsdReadsOtherwiseIsWrong) {
  const std::string log = sentence("GPGLL,5256.0000,N,00518.8170,E,094736,A,A") +
                          sentence("GPGLL,5257.0000,N,00518.8170,E,094737,A,A") +
                          sentence("GPGLL,5258.0000,N,00518.8170,E,094738,A,A");
  const std::string first = report_of("09:47:36.000", "52.933333333"),
                    last = report_of("09:47:38.000", "52.966666667");
  write("gps/gpsd/daemon/made.log", log);
  write("gps/gpsd/daemon/made.log.chk", first + report_of("09:47:37.000", "52.950000000") + last);
  EXPECT_TRUE(clean(score_all(root_)));
  write("gps/gpsd/daemon/made.log.chk", first + report_of("09:47:37.000", "52.950000300") + last);
  EXPECT_FALSE(clean(score_all(root_)));
}

/// Its GGA says quality 1 and 00 satellites, and gpsd has no report of it.
TEST_F(Scoreboard, APositionByNoSatellitesIsSaidAndNotWrong) {
  const auto gga = [](const char* time, const char* latitude, const char* satellites) {
    return sentence(std::string("GPGGA,") + time + "," + latitude + ",N,00518.8170,E,1," +
                    satellites + ",1.0,5.0,M,40.0,M,,");
  };
  write("gps/gpsd/daemon/made.log", gga("094736", "5256.0000", "08") +
                                        gga("094737", "5257.0000", "00") +
                                        gga("094738", "5258.0000", "08"));
  const std::string chk = report_of("09:47:36.000", "52.933333333") +
                          report_of("09:47:37.000", "52.933333333") +
                          report_of("09:47:38.000", "52.966666667");
  write("gps/gpsd/daemon/made.log.chk", chk);
  const auto results = score_all(root_);
  EXPECT_TRUE(clean(results));
  bool said = false;
  for (const auto& result : results)
    said |= result.score.rules().contains("a fix by no satellites");
  EXPECT_TRUE(said);
}

TEST_F(Scoreboard, AMakersOwnSentenceIsNoneOfItsLastLetters) {
  write("gps/gpsd/daemon/made.log", sentence("GPHDT,10.5,T") + sentence("PQGSV,1,1,00"));
  EXPECT_TRUE(clean(score_all(root_)));
}

TEST_F(Scoreboard, ASkyWithoutANumberIsAnErrorThatIsSaid) {
  std::string nav_sat{"\xB5\x62\x01\x35\x08\0\0\0\0\0\1\0\0\0", 14};
  unsigned char first = 0, second = 0;
  for (std::size_t i = 2; i < nav_sat.size(); ++i) {
    first = static_cast<unsigned char>(first + nav_sat[i]);
    second = static_cast<unsigned char>(second + first);
  }
  nav_sat += {static_cast<char>(first), static_cast<char>(second)};
  write("gps/gpsd/daemon/made.log", nav_sat);
  write("gps/gpsd/daemon/made.log.chk",
        R"({"class":"SKY","satellites":[{"gnssid":0,"el":10,"az":20,"used":true}]})"
        "\n");
  std::size_t errors = 0;
  for (const auto& result : score_all(root_)) errors += result.score.errors().size();
  EXPECT_EQ(errors, 1u);
}

/// The third ensemble of fixtures/pd0, whose NOTE.md says that it has no depth sensor.
TEST_F(Scoreboard, APressureWithoutASensorIsSaidAndNotWrong) {
  std::ifstream golden(DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0", std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(golden), {}};
  std::size_t begin = 0;
  const auto size_at = [&](std::size_t at) {
    return static_cast<unsigned char>(all[at + 2]) +
           256u * static_cast<unsigned char>(all[at + 3]) + 2;
  };
  for (int i = 0; i < 2; ++i) begin += size_at(begin);
  write("dvl/pd0/raw/made.PD0", all.substr(begin, size_at(begin)));
  write("dvl/pd0/expected/made.jsonl", R"({"i":0,"number":7,"pressure":0.0})"
                                       "\n");
  const Score score = only();
  EXPECT_TRUE(score.clean());
  EXPECT_EQ(score.rules().at("pressure without a sensor").messages, 1u);
}

/// The first record of fixtures/nortek-ad2cp, whose values its NOTE.md tells.
json row_of_the_first_golden_record() {
  return json::parse(R"({"at":0,"id":27,"family":16,"version":1,"offset_of_data":36,"serial":105236,
      "time":1795356239.0005,"number_of_beams":4,"error":0,"status":269484031,
      "sound_speed_mps":1500.25,"temperature_c":5.625,"pressure_bar":0.125,
      "beam_velocity_mps":[0.25,0.125,-0.25,-0.125],"beam_distance_m":[3.5,4,4.5,5],
      "beam_fom_mps":[0.001,0.002,0.003,0.004],"beam_dt1_s":[0.015,0.016,0.017,0.018],
      "beam_dt2_s":[-0.635,-0.634,-0.633,-0.632],"beam_duration_s":[0.009,0.0095,0.01,0.0105],
      "xyz_velocity_mps":[0.75,0.0625,-0.03125,0.0469],"xyz_fom_mps":[0.0021,0.0022,0.0012,0.0024],
      "xyz_dt1_s":[0.0161,0.0162,0.0163,0.0164],"xyz_dt2_s":[-0.6341,-0.6342,-0.6343,-0.6344],
      "xyz_duration_s":[0.0091,0.0092,0.0093,0.0094],"beam_velocity_valid":[1,1,1,1],
      "beam_distance_valid":[1,1,1,1],"beam_fom_valid":[1,1,1,1],"xyz_velocity_valid":[1,1,1,1],
      "xyz_fom_valid":[1,1,1,1],"idle_below_3_6_12":[0,0,0],"wakeup":1})");
}

TEST_F(Scoreboard, ABinaryRecordIsComparedToTheLastBitAndInEveryValidity) {
  std::ifstream golden(DRYDOCK_SOURCE_DIR "/fixtures/nortek-ad2cp/golden.nortek-ad2cp",
                       std::ios::binary);
  std::string record(222, '\0');
  golden.read(record.data(), 222);
  write("dvl/ad2cp/raw/made.bin", record);
  const auto wrong = [&](const json& row) {
    write("dvl/ad2cp/expected/made.jsonl", row.dump() + "\n");
    return only().counts().wrong;
  };
  const json row = row_of_the_first_golden_record();
  EXPECT_EQ(wrong(row), 0u);
  json other = row;
  other["xyz_velocity_mps"][3] = 0.046900004;  // the next float32
  EXPECT_EQ(wrong(other), 1u);
  other = row;
  other["beam_velocity_valid"][2] = 0;
  EXPECT_EQ(wrong(other), 1u);
}

TEST_F(Scoreboard, ADamagedBinaryRecordWithoutExpectedValuesMustGiveNone) {
  write("dvl/ad2cp/raw/made.bin", "\xA5\x0A\x1B\x10");
  write("dvl/ad2cp/expected/made.jsonl", "");
  EXPECT_TRUE(only().clean());
  write("dvl/ad2cp/expected/made.jsonl", row_of_the_first_golden_record().dump());
  EXPECT_EQ(only().counts().missed, 1u);
}

}  // namespace
}  // namespace drydock::conformance
