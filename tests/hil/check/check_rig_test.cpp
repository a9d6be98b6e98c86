#include "hil/check/check_rig.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "drivers/bus/domain.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "hil/check/check.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/hil/check/rig_folder.hpp"

/// What `run`, `drive` or `emulate` would refuse when they start, `check` refuses with its place.
namespace drydock::check {
namespace check_rig_test {

using decode::MemoryFile;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string rig_table = "[rig]\nname = \"r\"\n";

std::string device(const std::string& name, const std::string& kind, const std::string& protocol,
                   const std::string& link, const std::string& more = "") {
  return "[[device]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nprotocol = \"" + protocol +
         "\"\nlink = \"" + link + "\"\n" + more;
}

/// What `check` prints about a rig, without the folder; it must exit with 2.
std::string refusal_of(const std::string& text) {
  const RigFolder folder;
  const std::string path = folder.write("rigs/r.toml", text);
  MemoryFile out;
  EXPECT_EQ(check({path}, out.file()), 2);
  const std::string said = out.text();
  return said.substr(std::min(said.size(), path.size() - std::string("r.toml").size()));
}

std::string verdict_of(const std::string& text) {
  const RigFolder folder;
  MemoryFile out;
  return check({folder.write("rigs/r.toml", text)}, out.file()) == 0 ? "ok" : out.text();
}

std::vector<std::string> problems_for(Use use, const std::string& text) {
  const RigFolder folder;
  const std::string path = folder.write("rigs/r.toml", text);
  std::vector<std::string> lines;
  for (const auto& problem : check_rig(rig_config::load_rig(path, load_options()).value(), use))
    lines.push_back(to_string(problem).substr(path.size()));
  return lines;
}

TEST(CheckRig, AnAceinnaRateThatTheImuDoesNotHave) {
  const auto imu = [](const std::string& rate) {
    return rig_table + device("imu", "imu", "aceinna", "memory-can:bus",
                              "aceinna = { packet_rate_hz = " + rate + " }\n");
  };
  EXPECT_THAT(refusal_of(imu("30")), StartsWith("r.toml:8:30: /device/0/aceinna/packet_rate_hz: "));
  EXPECT_EQ(verdict_of(imu("25")), "ok");
}

TEST(CheckRig, AddressesOfJ1939EndAt253) {
  const auto depth = [](const std::string& address) {
    return rig_table +
           device("depth", "depth", "nmea2000", "memory-can:bus", "address = " + address + "\n");
  };
  EXPECT_EQ(verdict_of(depth("253")), "ok");
  for (const char* address : {"254", "255", "256"})
    EXPECT_THAT(refusal_of(depth(address)), StartsWith("r.toml:8:11: /device/0/address: "));
  const auto schema = nlohmann::json::parse(rig_config::schema_text());
  EXPECT_EQ(schema["definitions"]["device"]["properties"]["address"]["maximum"],
            wire::j1939::null_address - 1);
}

TEST(CheckRig, DdsDomainsEndWhereUdpPortsEnd) {
  constexpr int highest_port = 65535, base = 7400, gain = 250;  // OMG DDSI-RTPS 2.2, 9.6.1.1
  EXPECT_EQ(bus::highest_domain, (highest_port - base) / gain);
  const auto in_domain = [](int domain) {
    return rig_table + "dds_domain = " + std::to_string(domain) + "\n" +
           device("dvl", "dvl", "pd0", "memory:dvl");
  };
  EXPECT_EQ(verdict_of(in_domain(bus::highest_domain)), "ok");
  EXPECT_THAT(refusal_of(in_domain(bus::highest_domain + 1)),
              StartsWith("r.toml:3:14: /rig/dds_domain: "));
}

TEST(CheckRig, AnInterfaceThatThisComputerDoesNotHave) {
  const std::string rig =
      rig_table + "dds_interface = \"nowhere7\"\n" + device("dvl", "dvl", "pd0", "memory:dvl");
  EXPECT_THAT(refusal_of(rig), StartsWith("r.toml:3:17: /rig/dds_interface: "));
  EXPECT_THAT(problems_for(Use::lockstep, rig), IsEmpty());  // virtual time has no bus
}

TEST(CheckRig, AProtocolWithoutAnEmulatedDevice) {
  const auto gnss = [](const std::string& link) {
    return rig_table + device("gnss", "gnss", "ubx+nmea0183", link);
  };
  EXPECT_THAT(refusal_of(gnss("pty:gnss")), StartsWith("r.toml:6:12: /device/0/protocol: "));
  EXPECT_EQ(verdict_of(gnss("serial:/dev/ttyUSB0?baud=9600")), "ok");
}

TEST(CheckRig, ARealLinkHasNoVirtualTime) {
  const std::string rig =
      rig_table + device("dvl", "dvl", "pd0", "serial:/dev/ttyUSB0?baud=115200");
  EXPECT_EQ(verdict_of(rig), "ok");
  EXPECT_THAT(problems_for(Use::real_time, rig), IsEmpty());
  EXPECT_THAT(problems_for(Use::lockstep, rig),
              ElementsAre(StartsWith(":7:8: /device/0/link: device \"dvl\": serial:")));
  EXPECT_THAT(problems_for(Use::emulation, rig),
              ElementsAre(HasSubstr("no device has an emulated")));
}

TEST(CheckRig, ARecordingThatIsNotThereOrHoldsNoFrames) {
  EXPECT_THAT(refusal_of(rig_table + device("dvl", "dvl", "pd0", "file:none.log")),
              StartsWith("r.toml:7:8: /device/0/link: cannot open the recording "));
  EXPECT_THAT(refusal_of(rig_table + device("imu", "imu", "xsens", "file:r.toml")),
              StartsWith("r.toml:7:8: /device/0/link: "));
}

TEST(CheckRig, EmulatedDevicesThatShareATcpPortWriteItAlike) {
  const std::string link = "tcp:127.0.0.1:4711?emulated=1";
  const std::string first = rig_table + device("a", "dvl", "pd0", link);
  EXPECT_EQ(verdict_of(first + device("b", "dvl", "pd0", link)), "ok");
  EXPECT_THAT(refusal_of(first + device("b", "dvl", "pd0", link + "&clients=2")),
              StartsWith("r.toml:12:8: /device/1/link: tcp:127.0.0.1:4711 is the server of 'a' "
                         "too, which writes tcp:127.0.0.1:4711?emulated=1; "));
}

/// A real node may say position and attitude; an emulated device is a node of its own.
TEST(CheckRig, TwoEmulatedDevicesOnOneAddress) {
  const auto both = [](const std::string& link) {
    return rig_table + device("g", "gnss", "nmea2000", link, "address = 52\n") +
           device("a", "attitude", "nmea2000", link, "address = 52\n");
  };
  EXPECT_THAT(refusal_of(both("can:auto?name=n")),
              StartsWith("r.toml:14:11: /device/1/address: 52 is already the address of 'g'"));
}

/// What stands between two blanks needs a value, and nothing measures a text.
TEST(CheckRig, AnEmulatedDescriptionThatCanSendNothing) {
  const RigFolder folder;
  folder.write("rigs/ctd.toml",
               "[sensor]\ntitle = \"CTD\"\nkind = \"depth\"\n[protocol]\nchecksum = \"none\"\n"
               "[[protocol.lines]]\nname = \"sample\"\nfields = [\n"
               "{ name = \"day\", type = \"text\", ends = \" \" },\n"
               "{ field = \"pressure_pa\", unit = \"dbar\" }]\n");
  const std::string path =
      folder.write("rigs/r.toml", rig_table + device("d", "depth", "ctd.toml", "pty:d"));
  MemoryFile out;
  EXPECT_EQ(check({path}, out.file()), 2);
  EXPECT_THAT(out.text(), HasSubstr("/device/0/protocol: its emulated device can send nothing: "
                                    "'sample' has a field that nothing measures"));
}

TEST(CheckRig, AFaultOfADeviceThatIsNotEmulated) {
  EXPECT_THAT(refusal_of(rig_table + device("dvl", "dvl", "pd0", "tcp:10.0.0.7:4001") +
                         "[[fault]]\ndevice = \"dvl\"\nfault = \"off\"\n"),
              StartsWith("r.toml:8:1: /fault: device \"dvl\" is not emulated"));
}

TEST(CheckRig, AnEstimatorOfADeviceBehindThe32nd) {
  std::string rig = rig_table;
  for (int i = 0; i < 33; ++i)
    rig += device("imu" + std::to_string(i), "imu", "xsens", "memory-can:b" + std::to_string(i));
  const auto leveling = [](const std::string& imu) {
    return "[[estimator]]\nname = \"level\"\nkind = \"leveling\"\nmodel = \"stationary\"\nimu = "
           "\"" +
           imu + "\"\n";
  };
  EXPECT_EQ(verdict_of(rig + leveling("imu31")), "ok");
  EXPECT_THAT(refusal_of(rig + leveling("imu32")), StartsWith("r.toml:168:1: /estimator/0: "));
}

TEST(CheckRig, AMissionThatCannotBeSailed) {
  const RigFolder folder;
  const std::string mission = folder.write(
      "missions/m.toml",
      "[mission]\nlatitude_deg = 36\nlongitude_deg = -122\nspeed_mps = 1\n[[leg]]\nkind = "
      "\"dive\"\nduration_s = 10\ndepth_change_m = 50\n");
  const std::string rig =
      folder.write("rigs/r.toml", "[rig]\nname = \"r\"\nmission = \"../missions/m.toml\"\n" +
                                      device("dvl", "dvl", "pd0", "memory:dvl"));
  MemoryFile out;
  EXPECT_EQ(check({mission, rig}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith(mission + ":8:18: /leg/0/depth_change_m: mission leg 1: "));
  EXPECT_THAT(out.text(), HasSubstr("m.toml:8:18: /leg/0/depth_change_m: mission leg 1: this dive "
                                    "needs a pitch above 60 deg"));
}

TEST(CheckRig, AProgramThatSteersHasVirtualTimeAlone) {
  const RigFolder folder;
  folder.write("missions/m.toml",
               "[mission]\nlatitude_deg = 36\nlongitude_deg = -122\n[steering]\nfrom = "
               "\"program\"\ncommand = [\"./pilot\"]\n");
  const auto rig = rig_config::load_rig(
      folder.write("rigs/r.toml", "[rig]\nname = \"r\"\nmission = \"../missions/m.toml\"\n" +
                                      device("dvl", "dvl", "pd0", "memory:dvl")),
      load_options());
  ASSERT_TRUE(rig);
  EXPECT_THAT(check_rig(*rig), IsEmpty());
  EXPECT_THAT(check_rig(*rig, Use::lockstep), IsEmpty());
  for (const Use use : {Use::real_time, Use::emulation}) {
    const auto problems = check_rig(*rig, use);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_THAT(to_string(problems[0]),
                HasSubstr("m.toml:5:8: /steering/from: a program steers in virtual time alone: "
                          "allowed with run --speed max"));
  }
}

TEST(CheckRig, ARasterThatIsNone) {
  const RigFolder folder;
  folder.write("missions/bed.asc", "ncols 2\n");
  const std::string mission = folder.write(
      "missions/m.toml",
      "[mission]\nlatitude_deg = 36\nlongitude_deg = -122\nspeed_mps = 1\n[ocean.bed]\nkind = "
      "\"raster\"\nfile = \"bed.asc\"\n[[leg]]\nkind = \"straight\"\nduration_s = 10\n");
  MemoryFile out;
  EXPECT_EQ(check({mission}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith(mission + ":7:8: /ocean/bed/file: "));
  EXPECT_THAT(out.text(), HasSubstr("bed.asc:2: the file ends before its values"));
}

TEST(CheckRig, ASkyWithoutAnEphemerisOfItsTime) {
  const auto under_sky = [](const std::string& sky) {
    return rig_table + device("gnss", "gnss", "ubx", "memory:gnss", "emulate = { " + sky + " }\n");
  };
  EXPECT_THAT(refusal_of(under_sky("sky = { ephemeris = \"r.toml\" }")),
              StartsWith("r.toml:8:33: /device/0/emulate/sky/ephemeris: "));
}

}  // namespace check_rig_test
}  // namespace drydock::check
