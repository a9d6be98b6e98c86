// The program as a person or a script meets it: what it prints, what it exits with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/hil/cli/program.hpp"

namespace {

using testing::HasSubstr;

using program::drydock;
using program::Folder;
using program::read_file;

TEST(Program, HelpOfEveryCommandShowsAnExample) {
  for (const char* command :
       {"run",          "emulate", "drive",  "record", "estimate",   "check",     "monitor",
        "decode",       "replay",  "probe",  "doctor", "completion", "man",       "export",
        "cut",          "recover", "bisect", "sensor", "sky",        "maneuver",  "study",
        "characterize", "fault",   "proxy",  "soak",   "validity",   "scorecard", "load"}) {
    const auto help = drydock(std::string{command} + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_THAT(help.output, HasSubstr("Example")) << command;
  }
}

TEST(Program, WrongUsageAndWrongConfigurationExitWithTwo) {
  EXPECT_EQ(drydock("").exit_code, 2);
  EXPECT_EQ(drydock("sail").exit_code, 2);
  const auto duration = drydock("run rig_config/rigs/demo.toml --for 5parsec");
  EXPECT_EQ(duration.exit_code, 2);
  EXPECT_THAT(duration.output, HasSubstr("allowed: 90, 60s, 10min, 5.5h"));
  const auto missing = drydock("run nowhere.toml");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.output, HasSubstr("nowhere.toml"));
}

TEST(Program, AProxyRefusesWhatARealDeviceCannotBeMadeToDo) {
  const Folder folder;
  std::ofstream(folder / "f.toml") << "[[fault]]\ndevice = \"dvl\"\nfault = \"off\"\n"
                                      "[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\n";
  const auto proxy = drydock(
      "proxy 'serial:/dev/null?baud=9600' pty:dvl --protocol pd0 --device dvl "
      "--faults " +
      (folder / "f.toml").string());
  EXPECT_EQ(proxy.exit_code, 2);
  EXPECT_THAT(proxy.output, HasSubstr("f.toml:1:1: /fault: dvl \"dvl\" (pd0) cannot have the fault "
                                      "\"off\": behind the wire is a real device"));
  EXPECT_THAT(proxy.output, HasSubstr("f.toml:4:1: /fault"));
  EXPECT_THAT(proxy.output, HasSubstr("bottom-lost"));
}

TEST(Program, AProxyRefusesLinksThatDoNotFitEachOther) {
  const auto mixed = drydock("proxy pty:a socketcan:vcan0");
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_EQ(mixed.output, "proxy: pty:a carries bytes, socketcan:vcan0 does not\n");
  EXPECT_EQ(drydock("proxy pty:a pty:a").exit_code, 2);
  EXPECT_EQ(drydock("proxy file:dive.mcap pty:a").exit_code, 2);
  EXPECT_EQ(drydock("proxy pty:a pty:b --protocol xsens").exit_code, 2);
  const auto slcan = drydock("proxy socketcan:can0 slcan:pty:a --faults /dev/null");
  EXPECT_EQ(slcan.exit_code, 2);
}

// The whole way as three programs: emulated log, proxy, and what a driver would read.
TEST(Program, AProxyPassesAnEmulatedDeviceOnAndSumsUp) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"log\"\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"pty:real?baud=38400\"\nrate_hz = 20\n";
  std::ofstream(folder / "f.toml")
      << "[[fault]]\ndevice = \"log\"\nfault = \"drop\"\nprobability = 0.5\n";
  const auto run =
      drydock("emulate " + (folder / "rig.toml").string() +
              " --for 3s > /dev/null & " DRYDOCK_PROGRAM
              " proxy 'pty:real?baud=38400' pty:log --protocol nmea0183 --device log --faults " +
              (folder / "f.toml").string() + " --for 2s --json 2>/dev/null; wait");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto summary = nlohmann::json::parse(run.output);
  EXPECT_GT(summary["from_device"], 500);
  EXPECT_LT(summary["to_drivers"], summary["from_device"]);
  EXPECT_GT(summary["faults"]["drop"], 10);
  EXPECT_EQ(summary["lost"], 0);
}

TEST(Program, AStudyGivesTheSameFilesOnOneThreadAndOnThree) {
  const Folder folder;
  const auto study = [&](const std::string& jobs) {
    const auto json = folder / (jobs + ".json");
    const auto outcome = drydock("study leveling --runs 4 --jobs " + jobs + " --json " +
                                 json.string() + " --report " + (folder / jobs).string());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("leveling: 4 of 4 runs, seed 1"));
    return read_file(json) + read_file(folder / jobs / "index.html");
  };
  const auto alone = study("1");
  EXPECT_THAT(alone, HasSubstr("\"augmented\""));
  EXPECT_EQ(study("3"), alone);
}

TEST(Program, AStudyWithWrongArgumentsSaysWhatIsAllowed) {
  const auto name = drydock("study levelling");
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_EQ(name.output.find("study: 'levelling' is not known, allowed: leveling"), 0U);
  const auto runs = drydock("study leveling --runs 0");
  EXPECT_EQ(runs.exit_code, 2);
  EXPECT_THAT(runs.output, HasSubstr("1 to 1000000"));
}

TEST(Program, ABadLinkIsNamedWithFileLineAndColumn) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
         "link = \"seriel:/dev/ttyUSB0\"\nrate_hz = 5\n";
  const auto check = drydock("check " + (folder / "rig.toml").string());
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_THAT(check.output, HasSubstr("rig.toml:7:"));
  EXPECT_THAT(check.output, HasSubstr("serial"));
}

TEST(Program, TheShippedRigFilesAreGood) {
  const auto check = drydock("check rig_config/rigs/demo.toml rig_config/missions/*.toml");
  EXPECT_EQ(check.exit_code, 0) << check.output;
}

TEST(Program, ALockstepRunWritesAReportAndASummary) {
  const Folder folder;
  const auto run = drydock(
      "run rig_config/rigs/demo.toml --for 30s --speed max --expect-streaming "
      "--expect-rms 0.5 --json " +
      (folder / "s.json").string() + " --report " + (folder / "report").string());
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  EXPECT_EQ(summary["devices"].size(), 6u);
  EXPECT_DOUBLE_EQ(summary["duration_s"], 30.0);
  EXPECT_LT(summary["estimators"][0]["whole_run"]["roll_rms_deg"], 0.5);
  const auto page = read_file(folder / "report/index.html");
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("Roll: truth and estimate"));
  EXPECT_THAT(page, HasSubstr("6 of 6 devices streaming"));
  EXPECT_THAT(page, testing::Not(HasSubstr("src=")));
  EXPECT_THAT(page, testing::Not(HasSubstr("<link")));
}

TEST(Program, AnUnmetExpectationExitsWithOneAndSaysWhich) {
  const auto run =
      drydock("run rig_config/rigs/demo.toml --for 5s --speed max --expect-rms 0.000001");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("expected at most 1e-06"));
}

TEST(Program, ARealTimeRunStreamsFromAllSixDevices) {
  const auto run = drydock("run rig_config/rigs/demo.toml --for 6s --expect-streaming");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("CAN bus can:auto"));
}

TEST(Program, DriveAndEstimateAsTwoProcessesDoWhatRunDoesInOne) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml";
  const std::string log = (folder / "estimates.jsonl").string();
  const auto outcome = drydock(
      "emulate " + rig + " --for 10s > /dev/null & sleep 1; " DRYDOCK_PROGRAM " drive " + rig +
      " --for 7s > " + (folder / "drive.txt").string() + " & " DRYDOCK_PROGRAM " estimate " + rig +
      " --for 6s --json > " + log + "; r=$?; wait; exit $r");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << read_file(folder / "drive.txt");
  const auto text = read_file(log);
  // 100 Hz for the seconds in which all three run, less discovery and the filter's start.
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 200) << read_file(folder / "drive.txt");
}

TEST(Program, AFaultIsSetListedAndClearedWhileTheBenchRuns) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml",
                    fault = DRYDOCK_PROGRAM " fault " + rig + " ";
  const auto outcome =
      drydock("run " + rig + " --for 8s --json " + (folder / "s.json").string() + " > " +
              (folder / "run.txt").string() + " & sleep 3; " + fault +
              "set dvl garbage bytes=32 --for 1s; " + fault + "set emlog unplug; " + fault +
              "list; " + fault + "set emlog bottom-lost 2>&1; " + fault + "clear emlog; sleep 1; " +
              fault + "list; wait");
  EXPECT_THAT(outcome.output, HasSubstr("set: dvl: garbage, bytes = 32, for 1 s"));
  EXPECT_THAT(outcome.output, HasSubstr("emlog: unplug (since "));
  EXPECT_THAT(outcome.output, HasSubstr("only a dvl hears the sea bed"));
  EXPECT_THAT(outcome.output, HasSubstr("cleared: 1"));
  EXPECT_THAT(outcome.output, HasSubstr("no fault is in force"));
  EXPECT_THAT(read_file(folder / "run.txt"), HasSubstr(" s fault set: emlog: unplug"));
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  ASSERT_EQ(summary["faults"].size(), 2u) << summary["faults"];
  EXPECT_NEAR(summary["faults"][0]["until_s"].get<double>(),
              summary["faults"][0]["since_s"].get<double>() + 1, 0.001);
}

TEST(Program, AFaultNeedsABenchThatRunsAndSaysHowToStartOne) {
  const auto set = drydock("fault rig_config/rigs/demo.toml set dvl hang");
  EXPECT_EQ(set.exit_code, 1);
  EXPECT_THAT(set.output, HasSubstr("start one: drydock run rig_config/rigs/demo.toml"));
  const auto words = drydock("fault rig_config/rigs/demo.toml words");
  EXPECT_EQ(words.exit_code, 0);
  EXPECT_THAT(words.output, HasSubstr("bottom-lost"));
}

TEST(Program, AFileOfFaultsIsPutOnALockstepRunAndAWrongOneRefused) {
  const Folder folder;
  std::ofstream(folder / "f.toml")
      << "[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 5\nfor_s = 10\n";
  const std::string run = "run rig_config/rigs/demo.toml --for 20s --speed max --faults ";
  const auto outcome = drydock(run + (folder / "f.toml").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("fault 5.000 s to 15.000 s: emlog: hang"));
  std::ofstream(folder / "bad.toml") << "[[fault]]\ndevice = \"emlog\"\nfault = \"bottom-lost\"\n";
  const auto refused = drydock(run + (folder / "bad.toml").string());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("bad.toml:1:1: /fault: emlog \"emlog\""));
}

// Each process in its turn is killed without a word and started again. What the second drive
// printed is of a process that met ptys and buses as the first had left them.
TEST(Program, EitherProcessKilledAndStartedAgainStreamsFromAllDevices) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml";
  const auto in_background = [&](const std::string& what, const std::string& name) {
    return DRYDOCK_PROGRAM " " + what + " " + rig + " > " + (folder / name).string() + " 2>&1 & ";
  };
  const auto outcome = drydock(
      "--version; " + in_background("emulate", "emulate1.txt") + "emulate=$!; sleep 1; " +
      in_background("drive", "drive1.txt") + "drive=$!; sleep 3; kill -KILL $drive; " +
      in_background("drive", "drive2.txt") + "drive=$!; sleep 4; kill -KILL $emulate; sleep 1; " +
      in_background("emulate", "emulate2.txt") +
      "emulate=$!; sleep 6; kill -TERM $drive; wait $drive; "
      "echo drive ended with $?; kill -TERM $emulate; wait");
  const auto drive = read_file(folder / "drive2.txt");
  EXPECT_THAT(outcome.output, HasSubstr("drive ended with 0")) << drive;
  for (const char* device : {"imu", "dvl", "emlog", "gnss", "depth", "actuators"}) {
    const auto first = drive.find(std::string(device) + ": waiting -> streaming");
    EXPECT_NE(first, std::string::npos) << device << "\n" << drive;
  }
  EXPECT_THAT(drive, HasSubstr("-> backing off"));
}

TEST(Program, InterruptEndsARunCleanlyWithTheReport) {
  const Folder folder;
  const auto page = folder / "out/index.html";
  const auto outcome =
      drydock("run rig_config/rigs/demo.toml --report " + (folder / "out").string() +
              " > /dev/null & p=$!; sleep 5; kill -INT $p; wait $p");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(read_file(page), HasSubstr("interrupted"));
}

TEST(Program, TheSkyIsATableJsonAndAPlot) {
  const Folder folder;
  const std::string ask = "sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:59:42Z ";
  const auto table = drydock(ask);
  EXPECT_EQ(table.exit_code, 0) << table.output;
  EXPECT_THAT(table.output, HasSubstr("2026-11-21T10:00:00 GPS  (week 2445, 554400.000 s"));
  EXPECT_THAT(table.output, HasSubstr("G25  bad 63"));
  EXPECT_THAT(table.output, HasSubstr("refused: G26 of line 204"));
  EXPECT_THAT(table.output, testing::Not(HasSubstr("elevation")));

  const auto plot = (folder / "sky.svg").string();
  const auto json = drydock(ask + "--from 0,0,0 --json --plot " + plot);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  const auto sky = nlohmann::json::parse(json.output);
  ASSERT_EQ(sky["satellites"].size(), 25u);
  // Satellite 1 stands over the Gulf of Guinea at toe: (a, 0, 0).
  EXPECT_EQ(sky["satellites"][0]["prn"], 1);
  EXPECT_NEAR(sky["satellites"][0]["elevation_deg"], 90, 0.01);
  EXPECT_NEAR(sky["satellites"][0]["ecef_m"][0], 26'559'710, 1e-3);
  EXPECT_NEAR(sky["satellites"][0]["clock_s"], 1e-6, 1e-15);
  EXPECT_EQ(sky["refused"][0]["prn"], 26);
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
}

TEST(Program, AGradesAllanDeviationIsATableJsonAndAPlot) {
  const Folder folder;
  const std::string ask = "sensor rig_config/sensors/xsens-mti-630.toml --for 1h ";
  const auto table = drydock(ask);
  EXPECT_EQ(table.exit_code, 0) << table.output;
  EXPECT_THAT(table.output, HasSubstr("gyro [deg/h]"));

  const auto plot = (folder / "allan.svg").string();
  const auto json = drydock(ask + "--json --allan " + plot);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  for (const auto& row : nlohmann::json::parse(json.output)) {
    if (row["tau_s"] > 3) break;
    // 0.007 deg/s/sqrt(Hz) and 60 ug/sqrt(Hz) are 25.2 deg/h and 60 ug at 1 s.
    const double root = std::sqrt(row["tau_s"].get<double>());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(row["gyro_degph"][axis].get<double>() * root, 25.2, 0.1 * 25.2);
      EXPECT_NEAR(row["accelerometer_ug"][axis].get<double>() * root, 60, 0.1 * 60);
    }
  }
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
  EXPECT_EQ(drydock("sensor rig_config/sensors/water-linked-a50.toml").exit_code, 2);
}

TEST(Program, ASkyThatCannotBeToldExitsWithOneAndAWrongQuestionWithTwo) {
  const std::string file = "sky --ephemeris fixtures/rinex/walker.rnx ";
  const auto late = drydock(file + "--at 2026-11-21T13:00:00Z");
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.output, HasSubstr("has no record within 2 h of 2026-11-21T13:00:18 GPS"));
  EXPECT_EQ(drydock("sky --ephemeris README.md --at 2026-11-21T13:00:00Z").exit_code, 1);
  EXPECT_EQ(drydock(file + "--at noon").exit_code, 2);
  EXPECT_EQ(drydock(file + "--at 2026-11-21T10:00:00Z --from 91,0").exit_code, 2);
  EXPECT_EQ(drydock(file + "--at 2026-11-21T10:00:00Z --plot sky.svg").exit_code, 2);
}

TEST(Program, AManeuverIsATableJsonATrackAndAPlot) {
  const Folder folder;
  const std::string ask = "maneuver rig_config/vehicles/nps-auv-ii.toml turning-circle ";
  EXPECT_THAT(drydock(ask).output, HasSubstr("tactical diameter"));

  const auto plot = (folder / "c.svg").string(), track = (folder / "c.csv").string();
  const auto json = drydock(ask + "--deflection 10 --json --plot " + plot + " --csv " + track);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  const auto figures = nlohmann::json::parse(json.output);
  EXPECT_NEAR(figures["steady_turning_diameter_m"], 2 * 29.46, 0.6);
  EXPECT_NEAR(figures["steady_rate_of_turn_degps"], -3.189, 0.13);
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
  EXPECT_THAT(read_file(track),
              testing::StartsWith("t,u,v,w,p,q,r,x,y,z,phi,theta,psi,delta_r,delta_s,delta_b\n"
                                  "0,1.884955592,0,0,"));
}

TEST(Program, AManeuverWithoutVehicleScheduleOrPlaceToWriteSaysSo) {
  const std::string file = "maneuver rig_config/vehicles/nps-auv-ii.toml ";
  EXPECT_EQ(drydock(file).exit_code, 2);
  EXPECT_EQ(drydock("maneuver rig_config/rigs/demo.toml zigzag").exit_code, 2);
  const auto schedule = drydock(file + "--schedule README.md");
  EXPECT_EQ(schedule.exit_code, 2);
  EXPECT_THAT(schedule.output, HasSubstr("README.md:1: the header must be t,rudder"));
  const auto unwritable = drydock(file + "dive --csv /nowhere/track.csv");
  EXPECT_EQ(unwritable.exit_code, 1);
  EXPECT_THAT(unwritable.output, HasSubstr("/nowhere/track.csv: cannot be written"));
}

constexpr auto emulated_demo =
    "emulate rig_config/rigs/demo.toml --for 12s > /dev/null & sleep 1; " DRYDOCK_PROGRAM " ";

TEST(Program, AProbeFindsAnEmulatedSensorAndItsBlockIsAGoodRig) {
  const Folder folder;
  const auto outcome = drydock(std::string(emulated_demo) + "probe pty:dvl --for 8s --json; wait");
  const auto found = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(found["confidence"], "certain");
  EXPECT_EQ(found["attempts"][0]["findings"][0]["protocol"], "pd0");
  ASSERT_EQ(found["devices"].size(), 1u);
  EXPECT_EQ(found["devices"][0]["kind"], "dvl");
  EXPECT_NEAR(found["devices"][0]["rate_hz"], 5, 0.3);
  std::ofstream(folder / "rig.toml") << "[rig]\nname = \"probed\"\n"
                                     << found["devices"][0]["block"].get<std::string>();
  EXPECT_EQ(drydock("check " + (folder / "rig.toml").string()).exit_code, 0);
}

TEST(Program, AProbeOfAnEmulatedBusFindsDepthAndActuators) {
  const auto outcome =
      drydock(std::string(emulated_demo) + "probe 'can:auto?name=drydock0' --for 4s --json; wait");
  const auto found = nlohmann::json::parse(outcome.output);
  std::string kinds;
  for (const auto& device : found["devices"])
    kinds += device["kind"].get<std::string>() + device["address"].dump() + " ";
  EXPECT_EQ(kinds, "depth35 actuator36 ");
}

TEST(Program, AProbeOfARecordingNeedsNoTime) {
  const auto bytes = drydock("probe 'file:fixtures/pd0/golden.pd0?baud=115200'");
  EXPECT_EQ(bytes.exit_code, 0);
  EXPECT_THAT(bytes.output, HasSubstr("protocol = \"pd0\""));
  const auto frames = drydock("probe file:fixtures/nmea2000/frames.log");
  EXPECT_EQ(frames.exit_code, 0);
  EXPECT_THAT(frames.output, HasSubstr("protocol = \"nmea2000\""));
  EXPECT_EQ(drydock("probe file:/dev/null").exit_code, 1);
  EXPECT_EQ(drydock("probe serial:/dev/nowhere").exit_code, 2);
  EXPECT_EQ(drydock("probe").exit_code, 2);
}

TEST(Program, AMonitorOnlyListensSoANodeThatNobodyStartsStaysSilent) {
  const auto outcome =
      drydock(std::string(emulated_demo) +
              "monitor rig_config/rigs/demo.toml --once --for 4s; r=$?; wait; exit $r");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("imu        waiting"));
  EXPECT_THAT(outcome.output, HasSubstr("dvl        streaming"));
  EXPECT_THAT(outcome.output, HasSubstr("m/s"));
  EXPECT_THAT(outcome.output, HasSubstr("latency"));
  EXPECT_THAT(outcome.output, HasSubstr("load"));
  const auto quiet = drydock("monitor rig_config/rigs/demo.toml --once --json --for 1s");
  EXPECT_EQ(quiet.exit_code, 1);
  EXPECT_THAT(quiet.output, HasSubstr("\"state\":\"backing off\""));
}

TEST(Program, AMonitorReadsTheBusWhileAnotherProcessHasThePorts) {
  const auto outcome = drydock(std::string(emulated_demo) +
                               "drive rig_config/rigs/demo.toml --for 9s > /dev/null & "
                               "sleep 2; " DRYDOCK_PROGRAM
                               " monitor rig_config/rigs/demo.toml --bus --once --json --for 6s; "
                               "r=$?; wait; exit $r");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 6);
  EXPECT_THAT(outcome.output, HasSubstr("\"name\":\"velocity\""));
}

TEST(Program, TheDoctorNarrowsToARigAndNamesACommandForWhatIsWrong) {
  const auto machine = drydock("doctor --json");
  EXPECT_TRUE(nlohmann::json::parse(machine.output)["checks"].size() > 4) << machine.output;
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"x\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
         "link = \"serial:/dev/nowhere?baud=9600\"\n";
  const auto rig = drydock("doctor " + (folder / "rig.toml").string());
  EXPECT_EQ(rig.exit_code, 1);
  EXPECT_THAT(rig.output, HasSubstr("/dev/nowhere is not there"));
  EXPECT_THAT(rig.output, HasSubstr("drydock probe --all"));
}

TEST(Program, EveryCommandThatWritesAFileHasTheSameWordForReplacingOne) {
  for (const char* command : {"run", "record", "replay", "export", "recover", "cut", "bisect"}) {
    const auto help = drydock(std::string{command} + " --help");
    EXPECT_THAT(help.output, HasSubstr("--overwrite")) << command;
  }
  for (const char* everything : {"man", "completion bash", "completion zsh"}) {
    const auto text = drydock(everything).output;
    EXPECT_THAT(text, HasSubstr("overwrite")) << everything;
    EXPECT_THAT(text, testing::Not(HasSubstr("-force"))) << everything;
  }
}

TEST(Program, BashCompletesCommandsOptionsAndValues) {
  const Folder folder;
  std::ofstream(folder / "try.sh")
      << "source <(drydock completion bash)\n"
         "complete_at() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
         "_drydock; echo \"${COMPREPLY[*]}\"; }\n"
         "complete_at drydock mon\n"
         "complete_at drydock run --spe\n"
         "complete_at drydock run --speed m\n"
         "complete_at drydock decode --protocol pd\n";
  const auto outcome = drydock("--version; PATH=$(dirname " DRYDOCK_PROGRAM "):$PATH bash " +
                               (folder / "try.sh").string());
  EXPECT_THAT(outcome.output, HasSubstr("\nmonitor\n--speed\nmax\npd0 pd4 pd5 pd6\n"));
}

/// What an interactive zsh offers for the last word of each line, in a folder with two files.
class Zsh : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v zsh >/dev/null") != 0) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "zsh is missing";
      GTEST_SKIP() << "zsh is not installed (package zsh)";
    }
    std::ofstream(folder_ / "_drydock") << drydock("completion zsh").output;
    std::filesystem::create_directory(folder_ / "pier");
    for (const char* name : {"pier/pier.toml", "pier/dive.mcap"}) std::ofstream(folder_ / name);
  }
  std::string offers(const std::string& line) const {
    const auto offered = drydock("--version >/dev/null; cd " + (folder_ / "pier").string() +
                                 "; zsh -f " DRYDOCK_SOURCE_DIR "/tests/hil/cli/zsh_offers.zsh " +
                                 (folder_ / "").string() + " '" + line + "'");
    EXPECT_EQ(offered.exit_code, 0) << offered.output;
    return offered.output;
  }

  Folder folder_;
};

TEST_F(Zsh, OffersTheCommands) {
  const auto all = offers("drydock ");
  for (const char* command : {"probe", "monitor", "record", "replay", "export", "completion"})
    EXPECT_THAT(all, HasSubstr(std::string{command} + "\n"));
  EXPECT_EQ(offers("drydock rec"), "record\nrecover\n");
}

TEST_F(Zsh, OffersTheOptionsOfACommandAndTheirValues) {
  EXPECT_EQ(offers("drydock record -"),
            "--for\n--help\n--output\n--overwrite\n--serve\n--token\n-h\n-o\n");
  EXPECT_EQ(offers("drydock record -o a.mcap --o"), "--overwrite\n");  // one of both names
  EXPECT_EQ(offers("drydock run --speed "), "1\nmax\n");
  EXPECT_EQ(offers("drydock decode --protocol pd"), "pd0\npd4\npd5\npd6\n");
  EXPECT_EQ(offers("drydock record --for "), "");
}

TEST_F(Zsh, OffersFilesForARigAndForWhatAnOptionWrites) {
  EXPECT_EQ(offers("drydock record "), "dive.mcap\npier.toml\n");
  EXPECT_EQ(offers("drydock record p"), "pier.toml\n");
  EXPECT_EQ(offers("drydock record pier.toml -o "), "dive.mcap\npier.toml\n");
  const auto behind = offers("drydock record pier.toml ");  // there is one rig
  EXPECT_THAT(behind, HasSubstr("--output\n"));
  EXPECT_THAT(behind, testing::Not(HasSubstr("dive.mcap")));
  EXPECT_EQ(offers("drydock check pier.toml d"), "dive.mcap\n");
  EXPECT_EQ(offers("drydock replay d"), "dive.mcap\n");
}

TEST_F(Zsh, TakesTheCompletionFromSourceToo) {
  const auto outcome = drydock(
      "--version >/dev/null; PATH=$(dirname " DRYDOCK_PROGRAM
      "):$PATH zsh -f -c 'autoload -Uz compinit; compinit -D -u; source <(drydock completion zsh); "
      "print $_comps[drydock]'");
  EXPECT_EQ(outcome.output, "_drydock\n");
}

TEST(Program, TheManualPageIsSoundRoff) {
  const auto page = drydock("man | groff -man -ww -z");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_EQ(page.output, "");
  EXPECT_THAT(drydock("man").output, HasSubstr(".SS probe"));
}

}  // namespace
