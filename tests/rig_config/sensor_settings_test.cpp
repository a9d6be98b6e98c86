#include "tests/rig_config/problems.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/ubx/ubx_settings.hpp"

/// Settings that only some sensors or protocols have.
namespace drydock::rig_config::test {
namespace sensor_settings_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RigProblems, ACanopenNodeHasANarrowerRangeThanAJ1939Address) {
  EXPECT_THAT(
      problems_of(std::string(imu_table) + "address = 128\n"),
      ElementsAre("r.toml:13:11: /device/1/address: 128 is out of range, allowed: 0 to 127"));
}

TEST(RigProblems, ACanopenDeviceThatWouldStartEveryNodeIsRefused) {
  const auto table = [](const std::string& link) {
    return "[[device]]\nname = \"imu\"\nkind = \"imu\"\nprotocol = \"cia404-imu\"\nlink = \"" +
           link + "\"\n";
  };
  const std::string refusal =
      "/device/1/address: a CANopen device needs the node that its driver starts, allowed: 1 to "
      "127 (0 would start every node on the bus; none is needed on a file: or with listen=1)";
  EXPECT_THAT(problems_of(table("can:auto")), ElementsAre("r.toml:8:1: " + refusal));
  EXPECT_THAT(problems_of(table("can:auto") + "address = 0\n"),
              ElementsAre("r.toml:13:11: " + refusal));
  EXPECT_THAT(problems_of(table("can:auto") + "address = 1\n"), IsEmpty());
  EXPECT_THAT(problems_of(table("socketcan:can0?listen=1")), IsEmpty());
  EXPECT_THAT(problems_of(table("socketcan:can0?mode=listen")), IsEmpty());
  EXPECT_THAT(problems_of(table("file:dive.log")), IsEmpty());
}

TEST(RigProblems, AnInstanceIsForNmea2000AndDrivesOnly) {
  EXPECT_THAT(problems_of(std::string(imu_table) + "instance = 1\n"),
              ElementsAre("r.toml:13:1: /device/1/instance: not allowed here, only for protocol = "
                          "\"nmea2000\" or \"cia402\""));
  EXPECT_THAT(problems_of("[[device]]\nname = \"a\"\nkind = \"actuator\"\nprotocol = "
                          "\"nmea2000\"\nlink = \"can:auto\"\ninstance = 253\n"),
              ElementsAre(HasSubstr("/device/1/instance: 253 is out of range, allowed: 0 to 252")));
}

TEST(RigProblems, SettingsOfOneImuAreNotAnothers) {
  EXPECT_THAT(problems_of(std::string(imu_table) + "xsens = { extended = true }\n"),
              ElementsAre("r.toml:13:1: /device/1/xsens: not allowed here, only for protocol = "
                          "\"xsens\""));
  EXPECT_THAT(problems_of("sync = true\n"),
              ElementsAre("r.toml:8:1: /device/0/sync: not allowed here, only for CANopen "
                          "protocols"));
  EXPECT_THAT(problems_of(std::string(imu_table) + "sync = true\nheartbeat_timeout_s = 2\n"),
              IsEmpty());
}

TEST(RigProblems, AnXsensMessageThatDoesNotExistIsTold) {
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"i\"\nkind = \"imu\"\nprotocol = \"xsens\"\n"
                  "link = \"can:auto\"\nxsens = { identifiers = { rate_of_trun = 0x132 } }\n"),
      ElementsAre(HasSubstr("rate_of_trun: unknown key (did you mean 'rate_of_turn'?)")));
}

TEST(RigProblems, AGyroBiasOnADvlIsRefused) {
  EXPECT_THAT(
      problems_of("emulate = { gyro_bias_degph = 1 }\n"),
      ElementsAre(HasSubstr("r.toml:8:13: /device/0/emulate/gyro_bias_degph: unknown key")));
}

TEST(RigProblems, AKeyOfAnotherKindSaysWhereItBelongs) {
  EXPECT_THAT(problems_of("surface_pressure_pa = 101325\n"),
              ElementsAre("r.toml:8:1: /device/0/surface_pressure_pa: not allowed here, only for "
                          "kind = \"depth\""));
  EXPECT_THAT(
      problems_of("address = 3\n"),
      ElementsAre("r.toml:8:1: /device/0/address: not allowed here, only for protocols on a "
                  "CAN bus"));
}

TEST(RigProblems, TheStandardOceanNeedsALatitudeAndNoDensity) {
  const std::string depth =
      std::string(rig_table) +
      "[[device]]\nname = \"depth\"\nkind = \"depth\"\nprotocol = \"nmea2000\"\n"
      "link = \"can:auto\"\n";
  EXPECT_THAT(problems_of_text(depth + "depth_formula = \"unesco\"\nlatitude_deg = 30\n"),
              IsEmpty());
  EXPECT_THAT(problems_of_text(depth + "depth_formula = \"unesco\"\n"),
              ElementsAre(HasSubstr("latitude_deg")));
  EXPECT_THAT(problems_of_text(depth + "depth_formula = \"unesco\"\nlatitude_deg = 30\n"
                                       "water_density_kgm3 = 1025\n"),
              ElementsAre("r.toml:10:1: /device/0/water_density_kgm3: not allowed here, only with "
                          "depth_formula = \"density\""));
  EXPECT_THAT(problems_of_text(depth + "latitude_deg = 30\n"),
              ElementsAre("r.toml:8:1: /device/0/latitude_deg: not allowed here, only with "
                          "depth_formula = \"unesco\""));
}

TEST(RigProblems, APressureTransmitterIsSetByItsOwnTable) {
  const std::string depth =
      std::string(rig_table) +
      "[[device]]\nname = \"depth\"\nkind = \"depth\"\nlink = \"can:auto\"\n";  // to line 6
  const auto rig = load_rig_text(
      depth +
          "protocol = \"cia404-pressure\"\naddress = 1\n[device.pressure]\nformat = \"real32\"\n"
          "unit = \"bar\"\ndecimals = 3\nreference = \"gauge\"\n",
      "r.toml");
  ASSERT_TRUE(rig);
  const PressureConfig& pressure = rig->devices.at(0).pressure;
  EXPECT_EQ(pressure.format, "real32");
  EXPECT_EQ(pressure.unit, "bar");
  EXPECT_EQ(pressure.decimals, 3);
  EXPECT_TRUE(pressure.gauge);
  EXPECT_THAT(problems_of_text(depth + "protocol = \"nmea2000\"\npressure = { unit = \"bar\" }\n"),
              ElementsAre("r.toml:8:1: /device/0/pressure: not allowed here, only for protocol = "
                          "\"cia404-pressure\""));
}

TEST(RigProblems, WhatOnlySomeDvlProtocolsNeedIsRefusedElsewhere) {
  EXPECT_THAT(
      problems_of("maker = \"water-linked\"\nbeam_angle_deg = 30\nwater_linked = {}\n"),
      ElementsAre("r.toml:8:1: /device/0/maker: not allowed here, only for protocol = \"pd4\" or "
                  "\"pd6\"",
                  "r.toml:9:1: /device/0/beam_angle_deg: not allowed here, only for protocol = "
                  "\"pd4\" or \"pd5\"",
                  "r.toml:10:1: /device/0/water_linked: not allowed here, only for protocol = "
                  "\"water-linked\" or \"water-linked-json\""));
}

TEST(RigProblems, OldSentencesAreOfTheSerialProtocolAndRangeModesAreTheDvls) {
  const std::string json =
      "[rig]\nname = \"r\"\n[[device]]\nname = \"a\"\nkind = \"dvl\"\n"
      "protocol = \"water-linked-json\"\nlink = \"tcp:10.0.0.7:16171\"\n";
  EXPECT_THAT(problems_of_text(json + "water_linked = { old_sentences = true }\n"),
              ElementsAre("r.toml:8:18: /device/0/water_linked/old_sentences: not allowed here, "
                          "only for protocol = \"water-linked\""));
  for (const char* good : {"auto", "wt", "=0", "1<=3"})
    EXPECT_THAT(problems_of_text(json + "water_linked = { range_mode = \"" + good + "\" }\n"),
                ElementsAre())
        << good;
  for (const char* bad : {"", "5", "=5", "1<3"})
    EXPECT_EQ(problems_of_text(json + "water_linked = { range_mode = \"" + bad + "\" }\n").size(),
              1U)
        << bad;
}

constexpr auto receiver =
    "[rig]\nname = \"r\"\n[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
    "link = \"pty:g\"\n";

TEST(RigProblems, AUbloxMessageThatDoesNotExistIsTold) {
  EXPECT_THAT(problems_of_text(receiver + std::string("ublox = { messages = { NAV-PVD = 1 } }\n")),
              ElementsAre(HasSubstr("NAV-PVD: unknown key (did you mean 'NAV-PVT'?)")));
  EXPECT_THAT(problems_of_text(receiver + std::string("ublox = { rate_hz = 0 }\n")),
              ElementsAre(HasSubstr("/device/0/ublox/rate_hz: 0 is out of range")));
  EXPECT_THAT(problems_of("ublox = {}\n"),
              ElementsAre("r.toml:8:1: /device/0/ublox: not allowed here, only for protocol = "
                          "\"ubx\" or \"ubx+nmea0183\""));
}

TEST(RigProblems, EveryMessageThatAUbloxSendsByItselfCanBeSet) {
  for (const auto& message : wire::ubx::message_names) {
    const std::string name(message.name);
    EXPECT_THAT(problems_of_text(receiver + ("ublox = { messages = { " + name + " = 0 } }\n")),
                IsEmpty())
        << name;
  }
}

TEST(Rig, AUbloxsSettings) {
  const auto rig = load_rig_text(
      receiver + std::string("ublox = { rate_hz = 5, messages = { NAV-PVT = 1, GGA = 0 } }\n"),
      "r.toml");
  const UbloxConfig& ublox = rig.value().devices[0].ublox;
  EXPECT_EQ(ublox.rate_hz, 5);
  ASSERT_EQ(ublox.messages.size(), 2U) << "in the order of their names";
  EXPECT_EQ(ublox.messages[0].name, "GGA");
  EXPECT_EQ(ublox.messages[0].epochs, 0);
  EXPECT_EQ(ublox.messages[1].name, "NAV-PVT");
  EXPECT_EQ(ublox.messages[1].epochs, 1);
}

TEST(RigProblems, ASigmaOfVelocityIsOnlyForWhatMeasuresOne) {
  EXPECT_THAT(
      problems_of_text("[rig]\nname = \"r\"\n[[device]]\nname = \"a\"\nkind = \"gnss\"\n"
                       "protocol = \"ubx\"\nlink = \"pty:a\"\nvelocity_sigma_mps = 0.1\n"),
      ElementsAre("r.toml:8:1: /device/0/velocity_sigma_mps: not allowed here, only for kind = "
                  "\"dvl\" or \"emlog\""));
}

TEST(Rig, ASigmaOfVelocity) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n"
      "[[device]]\nname = \"a\"\nkind = \"emlog\"\nprotocol = \"nmea0183\"\nlink = \"pty:a\"\n"
      "velocity_sigma_mps = 0.05\n",
      "r.toml");
  EXPECT_EQ(rig.value().devices[0].velocity_sigma_mps, 0.05);
}

TEST(Rig, WhoseVelocityAWayfinderOrASignatureTells) {
  const std::string wayfinder =
      "[rig]\nname = \"r\"\n[[device]]\nname = \"a\"\nkind = \"dvl\"\n"
      "protocol = \"wayfinder\"\nlink = \"pty:a\"\n";
  std::string signature = wayfinder + "velocity_of = \"bed\"\n";
  signature.replace(signature.find("wayfinder"), 9, "nortek-ad2cp");
  EXPECT_EQ(load_rig_text(signature, "r.toml").value().devices[0].velocity_of_bed, true);
  EXPECT_EQ(load_rig_text(wayfinder, "r.toml").value().devices[0].velocity_of_bed, std::nullopt);
  for (const bool of_bed : {false, true}) {
    const std::string key = of_bed ? "velocity_of = \"bed\"\n" : "velocity_of = \"vehicle\"\n";
    EXPECT_EQ(load_rig_text(wayfinder + key, "r.toml").value().devices[0].velocity_of_bed, of_bed);
  }
  EXPECT_THAT(problems_of_text(wayfinder + "velocity_of = \"sea\"\n"),
              ElementsAre("r.toml:8:15: /device/0/velocity_of: \"sea\" is not allowed, allowed: "
                          "vehicle, bed"));
  EXPECT_THAT(problems_of("velocity_of = \"bed\"\n"),
              ElementsAre("r.toml:8:1: /device/0/velocity_of: not allowed here, only for protocol "
                          "= \"wayfinder\" or \"nortek-ad2cp\""));
}

TEST(Rig, ADvlsMakerBeamAngleAndSettings) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n"
      "[[device]]\nname = \"a\"\nkind = \"dvl\"\nprotocol = \"pd4\"\nlink = \"pty:a\"\n"
      "maker = \"water-linked\"\nbeam_angle_deg = 22.5\n"
      "[[device]]\nname = \"b\"\nkind = \"dvl\"\nprotocol = \"water-linked\"\nlink = \"pty:b\"\n"
      "[device.water_linked]\nmounting_rotation_deg = 180\nold_sentences = true\n",
      "r.toml");
  const auto& devices = rig.value().devices;
  EXPECT_EQ(devices[0].maker, DvlMaker::water_linked);
  EXPECT_DOUBLE_EQ(*devices[0].beam_angle_rad, 0.39269908169872414);
  EXPECT_FALSE(devices[0].water_linked);
  EXPECT_EQ(devices[1].maker, DvlMaker::teledyne);
  ASSERT_TRUE(devices[1].water_linked);
  EXPECT_FALSE(devices[1].water_linked->sound_speed_mps);
  EXPECT_DOUBLE_EQ(*devices[1].water_linked->mounting_rotation_rad, 3.141592653589793);
  EXPECT_TRUE(devices[1].water_linked->old_sentences);
  EXPECT_EQ(devices[1].water_linked->range_mode, "");
  EXPECT_FALSE(devices[1].water_linked->acoustic_enabled);
}

TEST(Rig, HowADvlWithJsonPings) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n"
      "[[device]]\nname = \"a\"\nkind = \"dvl\"\nprotocol = \"water-linked-json\"\n"
      "link = \"tcp:10.0.0.7:16171\"\n"
      "water_linked = { range_mode = \"=2\", acoustic_enabled = false, periodic_cycling = true }\n",
      "r.toml");
  const auto& settings = rig.value().devices[0].water_linked.value();
  EXPECT_EQ(settings.range_mode, "=2");
  EXPECT_EQ(settings.acoustic_enabled, false);
  EXPECT_EQ(settings.periodic_cycling, true);
}

TEST(RigProblems, ANegativeNoiseOfOneAxisPointsAtThatAxis) {
  EXPECT_THAT(problems_of("emulate = { velocity_noise_mps = [0.1, -0.1, 0.1] }\n"),
              ElementsAre("r.toml:8:40: /device/0/emulate/velocity_noise_mps/1: -0.1 is out of "
                          "range, allowed: 0 or more"));
}

}  // namespace sensor_settings_test
}  // namespace drydock::rig_config::test
