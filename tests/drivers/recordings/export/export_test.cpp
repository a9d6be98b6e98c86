#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/mcap/encoder.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"
#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"

namespace drydock::exporting {
namespace export_test {

using record::test::output_of;
using record::test::read_all;
using testing::HasSubstr;

bool there(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class Export : public testing::Test {
 protected:
  boost::system::result<Exported, record::RecordingError> to(
      Format format, const std::string& name, const record::Selection& selection = {},
      bool plain = false) {
    return export_recording(dive_, selection, format, {folder_ / name, false, plain},
                            [](double) { return true; });
  }

  record::test::TestFolder folder_;
  std::string dive_ = folder_ / "dive.mcap";
  record::test::SampleCounts counts_ = record::test::write_sample_dive(dive_);
};

TEST_F(Export, TsharkReadsBusAndSerialLinesFromOneFile) {
  ASSERT_TRUE(to(Format::pcapng, "dive.pcapng"));
  if (!there("tshark")) GTEST_SKIP() << "tshark is not installed (package tshark)";
  const auto packets = lines_of(output_of(
      "tshark -n -r " + (folder_ / "dive.pcapng") +
      " -d can.subdissector,j1939 -T fields -e frame.interface_name -e frame.time_epoch -e "
      "rtacser.timestamp -e rtacser.eventtype -e j1939.pgn 2>/dev/null"));
  const auto on = [&](std::string_view name) {
    return static_cast<std::size_t>(
        std::ranges::count_if(packets, [&](const auto& p) { return p.starts_with(name); }));
  };
  ASSERT_EQ(packets.size(), counts_.gnss_reads + counts_.dvl_reads + 1 + counts_.frames);
  EXPECT_EQ(on("gps\t"), counts_.gnss_reads);
  EXPECT_EQ(on("dvl\t"), counts_.dvl_reads + 1);
  EXPECT_EQ(on("can0\t"), counts_.frames);
  EXPECT_THAT(packets.front(), HasSubstr("\t1700000000.000000000\t1700000000.000000000\t0x02"));
  // The first frame of fixtures/nmea2000/frames.log is 128267, water depth.
  EXPECT_THAT(packets, testing::Contains(testing::AllOf(HasSubstr("can0\t"), HasSubstr("128267"))));
  EXPECT_THAT(packets.back(), HasSubstr("0x01"));  // the command that was sent
}

TEST_F(Export, CanUtilsReadTheCandumpLog) {
  const auto done = to(Format::candump, "dive.log");
  ASSERT_TRUE(done);
  EXPECT_EQ(done->written, counts_.frames);
  EXPECT_EQ(lines_of(read_all(folder_ / "dive.log")).front(),
            "(1700000000.000000) can0 0DF50B74#00D0000000FFFFFF");
  if (!there("log2asc")) GTEST_SKIP() << "log2asc is not installed (package can-utils)";
  const std::string asc = output_of("log2asc -I " + (folder_ / "dive.log") + " can0");
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(
                lines_of(asc), true,
                [](const std::string& line) { return line.find("Rx   d ") != std::string::npos; })),
            counts_.frames);
  EXPECT_THAT(asc, HasSubstr("DF50B74x"));
}

TEST_F(Export, ACandumpLogSaysWhoSentOnlyWhereItIsAskedFor) {
  const auto done = export_recording(
      dive_, {}, Format::candump,
      {.path = folder_ / "both.log", .overwrite = false, .plain = false, .direction = true},
      [](double) { return true; });
  ASSERT_TRUE(done);
  EXPECT_EQ(lines_of(read_all(folder_ / "both.log")).front(),
            "(1700000000.000000) can0 0DF50B74#00D0000000FFFFFF R");
}

TEST_F(Export, RawBytesAreThoseOfThePorts) {
  ASSERT_TRUE(to(Format::raw, "raw"));
  const std::string fixtures = std::string(DRYDOCK_SOURCE_DIR) + "/fixtures/";
  EXPECT_EQ(read_all(folder_ / "raw/dvl.bin"), read_all(fixtures + "pd0/golden.pd0"));
  EXPECT_EQ(read_all(folder_ / "raw/dvl.sent.bin"), "CS\r");
  EXPECT_EQ(read_all(folder_ / "raw/gps.bin"),
            read_all(fixtures + "ubx/golden.ubx") + read_all(fixtures + "nmea0183/golden.nmea"));
}

TEST_F(Export, NmeaTextHasEverySentence) {
  ASSERT_TRUE(to(Format::nmea, "plain.nmea", {}, true));
  const auto golden =
      lines_of(read_all(std::string(DRYDOCK_SOURCE_DIR) + "/fixtures/nmea0183/golden.nmea"));
  auto lines = lines_of(read_all(folder_ / "plain.nmea"));
  ASSERT_EQ(lines.size(), golden.size());
  for (std::size_t i = 0; i < golden.size(); ++i)
    EXPECT_EQ(lines[i], golden[i].substr(0, golden[i].find('\r')));
  ASSERT_TRUE(to(Format::nmea, "timed.nmea"));
  EXPECT_THAT(lines_of(read_all(folder_ / "timed.nmea")).front(),
              testing::MatchesRegex("17000000[0-9.]+ \\$GPGGA,092725.*"));
}

TEST_F(Export, CsvHasTheValuesThatTheFormatsOwnReaderFinds) {
  ASSERT_TRUE(to(Format::csv, "csv"));
  const auto rows = lines_of(read_all(folder_ / "csv/dvl_bottom_track.csv"));
  ASSERT_EQ(rows.size(), 21U);
  EXPECT_THAT(rows[0], testing::StartsWith("log_time [s],header.stamp.sec [s],header.stamp.nanosec "
                                           "[ns],header.frame_id,device_time.valid,"));
  EXPECT_THAT(rows[0], HasSubstr("velocity.x [m/s],velocity.y [m/s],velocity.z [m/s]"));
  EXPECT_THAT(rows[0], HasSubstr("range[0] [m],range[1] [m]"));
  EXPECT_THAT(rows[2], testing::StartsWith("1700000001.000000000,1700000001,0,dvl_link_frd,0,"));
  EXPECT_THAT(rows[2], HasSubstr(",1.5,0.25,-0.125,,"));  // the error velocity is not available
  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(dive_);
  const auto& last = found["indexed"]["topics"]["/gps/fix"]["last"];
  const auto fixes = lines_of(read_all(folder_ / "csv/gps_fix.csv"));
  EXPECT_THAT(fixes[0], HasSubstr("latitude [deg]"));
  EXPECT_THAT(fixes.back(), HasSubstr(last["latitude"].dump()));
}

TEST_F(Export, APartIsWhatItsNamesAndTimesSay) {
  record::Selection part;
  part.only = {"depth"};
  part.from = std::chrono::milliseconds{900};
  part.to = std::chrono::milliseconds{2700};
  EXPECT_EQ(to(Format::candump, "part.log", part)->written, 2U);
  part.only = {"dvk"};
  EXPECT_EQ(to(Format::candump, "none.log", part).error().line,
            "--only: there is no \"dvk\" in the recording; it has can0, depth, diagnostics, "
            "drydock, dvl, gps");
}

TEST_F(Export, WhatIsThereIsNotOverwrittenAndCtrlCEndsCleanly) {
  ASSERT_TRUE(to(Format::candump, "dive.log"));
  EXPECT_EQ(to(Format::candump, "dive.log").error().line,
            (folder_ / "dive.log") + ": File exists; --overwrite replaces it");
  int asked = 0;
  const auto ended =
      export_recording(dive_, {}, Format::candump, {folder_ / "two.log", false, false},
                       [&](double) { return ++asked < 20; });
  ASSERT_TRUE(ended);
  EXPECT_TRUE(ended->ended_early);
  EXPECT_LT(ended->written, counts_.frames);
}

TEST(ExportOfOthers, MessagesThatAreNotReadAreSaid) {
  const record::test::TestFolder folder;
  mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(file, mcap::Header{"ros2", "rosbag2"});
  mcap::encode(file,
               mcap::Schema{1, "a/msg/Pair", "ros2msg", "Half left\n===\nMSG: a/Half\nint8 of\n"});
  mcap::encode(file, mcap::Channel{1, 1, "/pair", "cdr", {}});
  const std::vector<std::uint8_t> read{0, 1, 0, 0, 7}, big_endian{0, 0, 0, 0, 7};
  mcap::encode(file, mcap::Message{1, 1, 9, 9, read});
  mcap::encode(file, mcap::Message{1, 2, 9, 9, big_endian});
  std::ofstream(folder / "bag.mcap", std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  const auto done =
      export_recording(folder / "bag.mcap", {}, Format::csv, {folder / "tables", false, false},
                       [](double) { return true; });
  ASSERT_TRUE(done) << done.error().line;
  EXPECT_EQ(done->written, 1U);
  EXPECT_THAT(read_all(folder / "tables/pair.csv"), HasSubstr("left.of\n0.000000009,7\n"));
  EXPECT_THAT(done->notes,
              testing::ElementsAre("/pair: 1 message is not read: its CDR begins with 00 00, and "
                                   "only plain CDR, little endian (00 01) is read"));
}

}  // namespace export_test
}  // namespace drydock::exporting
