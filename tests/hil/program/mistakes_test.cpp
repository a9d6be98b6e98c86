// Mistakes that people make on the command line: each is told with what is wrong and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "tests/hil/program/program.hpp"

namespace mistakes_test {

using program::drydock;
using program::Folder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string dive = "fixtures/dives/dvl-finds-the-bottom/dive.mcap";

struct Mistake {
  std::string arguments;
  int exit_code;
  std::string says;
};

void expect_told(const std::vector<Mistake>& mistakes) {
  for (const auto& mistake : mistakes) {
    const auto told = drydock(mistake.arguments);
    EXPECT_EQ(told.exit_code, mistake.exit_code) << mistake.arguments << "\n" << told.output;
    EXPECT_THAT(told.output, HasSubstr(mistake.says)) << mistake.arguments;
    EXPECT_THAT(told.output, Not(HasSubstr(":0:0:"))) << mistake.arguments;
  }
}

TEST(Mistakes, ANumberThatCannotBeIsWrongUsage) {
  expect_told({
      {"run demo --for 1s --seed -1", 2, "'-1' is no seed; allowed: a whole number, 0 or more"},
      {"study mixing --runs 1 --seed x", 2, "'x' is no seed"},
      {"sensor xsens-mti-630 --rate -5", 2, "'-5' is not allowed; allowed: a number above 0"},
      {"sensor xsens-mti-630 --rate nan", 2, "'nan' is not allowed"},
      {"run demo --for 1s --speed max --expect-rms -1", 2, "allowed: a number above 0"},
      {"track " + dive + " --start 95,20", 2, "latitude,longitude in degrees"},
      {"run demo --for 1s --serve 70000", 2,
       "'70000' is no address; allowed: PORT or ADDRESS:PORT"},
      {"monitor demo --serve here", 2, "'here' is no address"},
  });
}

TEST(Mistakes, ACommandThatIsMissingIsAskedFor) {
  expect_told({{"", 2, "which command? drydock --help lists them"},
               {"fault demo", 2, "fault: which? one of set, clear"},
               {"run", 2, "RIG is required"}});
}

TEST(Mistakes, AWordTooManyIsNamedWithThoseThatTheCommandTakes) {
  expect_told({
      {"decode pd0 dive.pd0", 2, "pd0 is a protocol and no file: --protocol pd0"},
      {"run demo 10s", 2, "run: '10s' is one word too many; it takes RIG, and any other value"},
      {"sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:00:00Z now", 2,
       "sky: 'now' is one word too many; it takes no word, and"},
  });
}

TEST(Mistakes, AWordOfAListIsComparedWithTheList) {
  expect_told({
      {"example demoo", 2, "named 'demoo' (did you mean 'demo'?); drydock example lists them"},
      {"new mision x", 2, "vehicle} (did you mean 'mission'?)"},
      {"new foo x", 2, "KIND: foo not in {rig,mission,waypoints,sensor,vehicle}\n"},
      {"new rig 1x", 2, "'1x' is no name; allowed: my-bench, a letter first"},
      {"score a.csv --truth b.mcap --align yow", 2,
       "yow not in {none,start,yaw,rigid} (did you mean 'yaw'?)"},
      {"score a.csv --truth b.mcap --interval 1e10", 2, "allowed: 1e-9 to 1e9 seconds"},
  });
}

TEST(Mistakes, AFileThatIsNotThereIsComparedWithThoseThatAre) {
  expect_told({
      {"run demmo --for 1s", 2,
       "demmo: cannot be read: No such file or directory (did you mean 'demo'?)"},
      {"run demo.tml --for 1s", 2, "(did you mean 'demo'?)"},
      {"check dmo", 2, "(did you mean 'demo'?)"},
      {"maneuver nps-auv-i zigzag", 2, "(did you mean 'nps-auv-ii'?)"},
      {"replay " + dive + " --rig demmo", 2, "(did you mean 'demo'?)"},
      {"track fixtures/dives/dvl-finds-the-bottom/div.mcap", 1, "(did you mean 'dive.mcap'?)"},
      {"monitor dmeo", 2, "(did you mean 'demo'?)"},
      {"monitor dmeo --protocol pd0", 2, "(did you mean 'demo'?)"},
      {"diagnose dmeo", 2, "(did you mean 'demo'?)"},
      {"monitor nothing-like-it", 2, "there is no file, port or CAN interface"},
      {"monitor tcp:x", 2, "tcp needs host:port"},
      {"run nothing-like-it --for 1s", 2, "`drydock example` lists the files"},
  });
}

/// A file by its path, a port by its name.
TEST(Mistakes, AMessageMonitorTakesThePortsThatAProbeTakes) {
  expect_told({
      {"monitor fixtures/pd0/golden.pd0 --protocol pd4 --for 1s", 1, "1268 skipped"},
      {"monitor ttyUSB0 --protocol pd0 --for 1s", 2, "serial needs a baud rate"},
      {"monitor /dev/ttyUSB0 --protocol pd0 --for 1s", 2, "serial needs a baud rate"},
  });
}

TEST(Mistakes, AProbeForASensorOfNoKindSaysWhoReadsIt) {
  const Folder folder;
  const std::string file = (folder / "any.toml").string();
  std::ofstream(file) << "[sensor]\ntitle = \"any\"\n[[protocol.binary]]\nname = \"a\"\n"
                         "sync = \"A0 A1\"\nlength = 4\n"
                         "fields = [{ at = 2, type = \"u8\", name = \"n\" }]\n";
  expect_told({{"probe pty:nobody --describe " + file, 2, "has no key 'kind'"}});
}

TEST(Mistakes, AnEmptyFileIsCalledEmptyByThoseThatMakeATrackToo) {
  const Folder folder;
  const std::string empty = (folder / "empty.mcap").string();
  std::ofstream{empty};
  const std::string to = (folder / "twin").string();
  expect_told({{"track " + empty, 1, "is empty"},
               {"calibrate " + empty, 1, "is empty"},
               {"twin " + empty + " -o " + to, 1, "is empty"}});
  EXPECT_FALSE(std::filesystem::exists(to));
}

TEST(Mistakes, AFolderOrADeviceIsNoFile) {
  expect_told({{"info /dev/null", 1, "is a device or a pipe, not a file"},
               {"diagnose .", 1, "is a folder, not a file"},
               {"track .", 2,
                "--rig, whose devices read several captures, or --protocol of the one sensor"}});
}

TEST(Mistakes, ANameOfAShippedFileIsTakenByEveryCommandOfThatKind) {
  expect_told({{"check demo", 0, "demo.toml: ok"},
               {"check s-path", 0, "s-path.toml: ok"},
               {"check nps-auv-ii", 0, "nps-auv-ii.toml: ok"},
               {"monitor demo --once --for 1s", 1, "dvl pd0 on pty:dvl"},
               {"diagnose demo --for 1s", 1, "0 of 6 devices heard"}});
}

TEST(Mistakes, ARecordingOrACaptureIsNoRigFile) {
  const std::string why = ", no TOML file: drydock info says what is in it";
  expect_told({{"check " + dive, 2, "is an MCAP recording" + why},
               {"run fixtures/capture/le.pcapng", 2, "is a pcapng capture" + why},
               {"emulate fixtures/pd0/golden.pd0", 2, "is a binary file" + why},
               {"probe " + dive, 1, "it is an MCAP recording: drydock info"}});
}

TEST(Mistakes, ASourceThatIsNotInARigIsComparedWithThoseThatAre) {
  expect_told({{"topic demo sonar", 2,
                "it has dvl, emlog, gnss, imu, depth, actuators, leveling, diagnostics"}});
}

TEST(Mistakes, ARecordingIsNoCaptureOfALine) {
  expect_told({{"decode " + dive + " --protocol pd0", 1,
                "is a recording of a rig: drydock replay and drydock topic read it"}});
}

/// The magic of ASAM MDF 4: the file identifier "MDF     ", of a logger that was cut "UnFinMF ".
TEST(Mistakes, AnMf4FileIsToldHowItIsConverted) {
  const Folder folder;
  const auto file = (folder / "dive.mf4").string();
  for (const char* magic : {"MDF     ", "UnFinMF "}) {
    std::ofstream(file) << magic << "4.10    drydock" << std::string(100, '\x01');
    const std::string why = "it is ASAM's MF4, which is not read";
    expect_told({{"decode " + file, 1, why},
                 {"decode " + file + " --protocol pd0", 1, why},
                 {"decode " + file + " --protocol nmea2000", 1, "python3 -m can.logconvert"},
                 {"replay " + file + " --protocol pd0", 1, why},
                 {"track " + file + " --protocol pd0", 1, why}});
  }
}

TEST(Mistakes, SeveralCapturesNeedTheRigThatReadsThem) {
  const std::string pd0 = "fixtures/pd0/golden.pd0 ";
  expect_told({
      {"replay " + pd0 + pd0, 2, "--rig, whose devices read several captures, is required"},
      {"replay " + pd0, 2, "--protocol, or --rig (fixtures/pd0/golden.pd0 is no MCAP recording)"},
      {"replay " + pd0 + "--rig demo --kind dvl", 2, "the rig file says it of each of its devices"},
      {"replay " + pd0 + dive + " --rig demo", 1, dive + ": a recording is played alone"},
      {"replay sonar=" + pd0 + "--rig demo --quiet", 2, "no device of"},
      {"replay dvl=" + pd0 + "--rig demo --quiet", 0, "golden.pd0 (1268 bytes): read by dvl"},
      {"track " + pd0 + pd0, 2, "--rig, whose devices read several captures, or --protocol"},
      {"compare sonar=" + pd0 + "--rig demo --estimators leveling", 2, "no device of"},
      {"track fixtures/nmea0183 --protocol pd0", 1, "made no measurement of it"},
  });
}

TEST(Mistakes, AWrongProtocolIsToldWhichOneItLooksLike) {
  expect_told({
      {"decode fixtures/pd0/golden.pd0 --protocol nmea0183", 1, "the bytes look like pd0"},
      {"replay fixtures/pd0/golden.pd0 --protocol ubx", 1, "the bytes look like pd0"},
      {"replay fixtures/pd0/golden.pd0 --protocol foo", 2,
       "no driver speaks \"foo\"; allowed: ubx, "},
      {"decode fixtures/pd0/golden.pd0 --protocol nmea-depth", 2,
       "no driver speaks \"nmea-depth\" (did you mean 'nmea-depth.toml'?); allowed: ubx, "},
      {"replay fixtures/pd0/golden.pd0 --protocol pd00", 2, "(did you mean 'pd0'?)"},
      {"monitor can:auto --protocol pd0", 2,
       "a CAN link carries no protocol \"pd0\"; allowed: nmea2000"},
      {"monitor tcp:127.0.0.1:9 --protocol nmea2000", 2,
       "a byte link carries no protocol \"nmea2000\"; allowed: ubx"},
  });
}

/// The emulated DVL of the demo rig sends PD0.
TEST(Mistakes, ARecordOfTheWrongProtocolIsToldWhichOneItLooksLike) {
  const Folder folder;
  const auto rig = (folder / "rig.toml").string();
  std::ofstream(rig) << "[rig]\nname = \"wrong\"\n[[device]]\nname = \"head\"\nkind = \"dvl\"\n"
                        "protocol = \"pd4\"\nlink = \"pty:dvl\"\nrate_hz = 5\n";
  const auto told = drydock(program::emulated_demo + "record " + rig + " --for 4s -o " +
                            (folder / "dive.mcap").string());
  EXPECT_EQ(told.exit_code, 1) << told.output;
  EXPECT_THAT(told.output, HasSubstr("head: bytes, but no pd4 frame; they look like pd0\n"));
}

TEST(Mistakes, AnOptionAndItsValueAreToldInTheirOrder) {
  expect_told(
      {{"run demo --spede max", 2, "run: there is no option --spede (did you mean '--speed"}});
}

TEST(Mistakes, AReplayWithoutAMeasurementIsNeverSilent) {
  const Folder folder;
  const std::string noise = (folder / "noise.bin").string();
  std::ofstream(noise) << std::string(500, '\x55');
  expect_told({{"replay " + noise + " --protocol pd0 --quiet", 1,
                "replay: " + noise + ": no measurement\n"}});
}

TEST(Mistakes, ADecodeOfNothingSaysWhatIsMissing) {
  const Folder folder;
  const std::string empty = (folder / "empty.bin").string();
  std::ofstream{empty};
  expect_told({{"decode " + empty + " --protocol pd0", 1, "is empty"},
               {"decode fixtures/pd0/golden.pd0", 2, "drydock probe FILE finds the protocol"}});
}

TEST(Mistakes, AFailureBeginsWithTheNameOfItsCommand) {
  for (const std::string command : {"track", "calibrate", "info", "diagnose"})
    expect_told({{command + " /dev/null", 1, command + ": /dev/null: is a device or a pipe"}});
}

TEST(Mistakes, ATopicMayHaveTheNameThatDdsGivesIt) {
  expect_told({{"topic " + dive + " rt/dvl/bottom_track --count 1", 0, "/dvl/bottom_track"}});
}

TEST(Mistakes, AStartBehindTheEndIsCalledThat) {
  expect_told(
      {{"replay " + dive + " --from 1000s --quiet", 1, "the recording ends before --from 1000 s"}});
}

TEST(Mistakes, AnOutputOfAReplayThatCannotBeWrittenIsAFailure) {
  expect_told({
      {"replay " + dive + " --quiet --update-refs /dev/full", 1,
       "cannot write /dev/full: No space left on device"},
      {"replay " + dive + " --quiet --report /dev/null", 1, "cannot write /dev/null/index.html"},
  });
}

TEST(Mistakes, AFileThatDidNotFitIsNotLeftBehindInPart) {
  const Folder folder;
  const std::string page = (folder / "out").string();
  const std::string at_most_4_kb = "trap '' XFSZ; ulimit -f 8;";
  const auto full =
      drydock("run demo --for 2s --speed max --report " + page + " --json /dev/null", at_most_4_kb);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.output, HasSubstr("index.html: File too large"));
  EXPECT_FALSE(std::filesystem::exists(page + "/index.html"));
}

TEST(Mistakes, ACaptureHasAReportToo) {
  const Folder folder;
  const std::string page = (folder / "out").string();
  const auto replayed =
      drydock("replay fixtures/pd0/golden.pd0 --protocol pd0 --quiet --report " + page);
  EXPECT_EQ(replayed.exit_code, 0) << replayed.output;
  EXPECT_THAT(program::read_file(page + "/index.html"), HasSubstr("golden.pd0"));
}

TEST(Mistakes, ASilentNodeIsExplainedByTheDiagnosisToo) {
  const auto told = drydock(program::emulated_demo + "diagnose demo --for 3s");
  EXPECT_THAT(told.output, HasSubstr("imu: no measurement came in"));
  EXPECT_THAT(told.output, HasSubstr("node 1 is pre-operational: nobody started it"));
  EXPECT_THAT(told.output, Not(HasSubstr("nothing found in")));
}

}  // namespace mistakes_test
