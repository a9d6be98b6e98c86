#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "rig_config/fault.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/drivers/described/support.hpp"

/// What a description cannot take from its DBC file is refused with line, column and what is
/// allowed.
namespace drydock::described::test {
namespace dbc_refusal_test {

using ::testing::HasSubstr;
using ::testing::Not;

/// Lines 1 to 4 are the head; `more` begins at line 5.
std::string imu(std::string_view more) {
  return problems_of("[sensor]\ntitle = \"t\"\nkind = \"imu\"\n[protocol]\n" + std::string(more));
}

std::string xsens(std::string_view more) {
  return imu("dbc = \"xsens.dbc\"\n" + std::string(more));
}

constexpr std::string_view rate =
    "[[protocol.frames]]\nmessage = \"rate_of_turn\"\n"
    "fields = [{signal = \"rate_x_degps\", field = \"rate_x_degps\"}]\n";

constexpr std::string_view rates_and_forces = R"(
[[protocol.frames]]
message = "rate_of_turn"
fields = [
  {signal = "rate_x_degps", field = "rate_x_degps"},
  {signal = "rate_y_degps", field = "rate_y_degps"},
  {signal = "rate_z_degps", field = "rate_z_degps"},
]
[[protocol.frames]]
message = "acceleration"
fields = [
  {signal = "acceleration_x_mps2", field = "force_x_mps2"},
  {signal = "acceleration_y_mps2", field = "force_y_mps2"},
  {signal = "acceleration_z_mps2", field = "force_z_mps2"},
]
)";

TEST(DbcProblems, AMessageAndASignalThatTheFileDoesNotHaveAreRefusedWithThoseThatItHas) {
  EXPECT_THAT(xsens("[[protocol.frames]]\nmessage = \"rate_of_turm\"\nfields = []\n"),
              HasSubstr("toy.toml:7:11: /protocol/frames/0/message: the DBC file has no message "
                        "\"rate_of_turm\" (did you mean 'rate_of_turn'?), allowed: error, "));
  EXPECT_THAT(xsens("[[protocol.frames]]\nmessage = \"rate_of_turn\"\n"
                    "fields = [{signal = \"gyrX\", field = \"rate_x_degps\"}]\n"),
              HasSubstr("toy.toml:8:21: /protocol/frames/0/fields/0: message rate_of_turn has no "
                        "signal \"gyrX\", allowed: rate_x_degps, rate_y_degps, rate_z_degps\n"));
}

TEST(DbcProblems, AFileThatIsNowhereIsRefused) {
  EXPECT_THAT(imu("dbc = \"xens.dbc\"\n" + std::string(rate)),
              HasSubstr("toy.toml:5:7: /protocol/dbc: there is no file xens.dbc, and the program "
                        "contains no \"xens.dbc\" (did you mean 'xsens.dbc'?)"));
}

TEST(DbcProblems, AFolderOrADeviceInPlaceOfAFileIsNamedWithTheLineOfTheDescription) {
  EXPECT_THAT(imu("dbc = \"/\"\n" + std::string(rate)),
              HasSubstr("toy.toml:5:7: /protocol/dbc: /: cannot be read: is a folder, not a file"));
  EXPECT_THAT(imu("dbc = \"/dev/zero\"\n" + std::string(rate)),
              HasSubstr("toy.toml:5:7: /protocol/dbc: /dev/zero: cannot be read: is a device or a "
                        "pipe, not a file"));
}

/// 16 MiB are allowed, of a description as of `decode --dbc`.
TEST(DbcProblems, AFileThatIsTooLargeIsRefusedWithTheLineOfTheDescription) {
  const auto path = (std::filesystem::path(::testing::TempDir()) / "large.dbc").string();
  const auto problems_of_size = [&](std::size_t bytes) {
    std::ofstream(path) << "BU_: s\nCM_ \"" << std::string(bytes - 15, 'x') << "\";\n";
    EXPECT_EQ(std::filesystem::file_size(path), bytes);
    return imu("dbc = \"" + path + "\"\n" + std::string(rate));
  };
  EXPECT_THAT(problems_of_size(20'000'000),
              HasSubstr("toy.toml:5:7: /protocol/dbc: " + path +
                        " has 20000000 bytes, allowed: up to 16777216 (16 MiB)\n"));
  EXPECT_THAT(problems_of_size(2'000'000),
              HasSubstr("the DBC file has no message \"rate_of_turn\""));
  std::filesystem::remove(path);
}

TEST(DbcProblems, FramesWithoutAFileAndAFileWithoutFramesAreRefused) {
  EXPECT_THAT(imu(rate), HasSubstr("frames need the key 'dbc'"));
  EXPECT_THAT(xsens("[[protocol.sentences]]\nid = \"$PX\"\nfields = [{name = \"x\"}]\n"),
              HasSubstr("toy.toml:5:7: /protocol/dbc: a DBC file describes frames"));
}

TEST(DbcProblems, KeysOfBytesAreRefusedBesideADbcFile) {
  EXPECT_THAT(xsens("checksum = \"xor\"\n" + std::string(rate)),
              HasSubstr("toy.toml:6:12: /protocol/checksum: only for bytes"));
  EXPECT_THAT(xsens(std::string(rate) + "[[poll]]\nsend = \"x\"\n"),
              HasSubstr("/poll: only for bytes"));
}

TEST(DbcProblems, TwoMessagesOfOneSampleThatMeasureTheSameAreRefused) {
  const std::string twice =
      std::string(rate) + "[[protocol.frames]]\nmessage = \"rate_of_turn_hr\"\n";
  const std::string fields = "fields = [{signal = \"rate_x_degps\", field = \"rate_x_degps\"}]\n";
  EXPECT_THAT(
      xsens(twice + fields),
      HasSubstr("toy.toml:9:1: /protocol/frames/1: the message of line 6 measures the same"));
  EXPECT_THAT(xsens(twice + "sample = \"hr\"\n" + fields), Not(HasSubstr("measures the same")));
}

TEST(DbcProblems, AUnitOfTheFileThatDoesNotFitIsRefused) {
  EXPECT_THAT(xsens("[[protocol.frames]]\nmessage = \"acceleration\"\n"
                    "fields = [{signal = \"acceleration_x_mps2\", field = \"rate_x_degps\"}]\n"),
              HasSubstr("\"m/s2\" is no unit of rate_x_degps, allowed: rad/s"));
}

TEST(DbcProblems, ACounterAndAChecksumMustBeWhereTheFileHasThem) {
  const auto with = [](std::string_view key) {
    return xsens("[[protocol.frames]]\nmessage = \"rate_of_turn\"\n" + std::string(key) +
                 "\nfields = [{signal = \"rate_x_degps\", field = \"rate_x_degps\"}]\n");
  };
  EXPECT_THAT(
      with("counter = {signal = \"rate_x_degps\"}"),
      HasSubstr("toy.toml:8:21: /protocol/frames/0/counter/signal: a counter is an unsigned"));
  EXPECT_THAT(with("checksum = {signal = \"rate_x_degps\", kind = \"crc8\"}"),
              HasSubstr("\"crc8\" is no checksum of frames"));
  EXPECT_THAT(with("checksum = {signal = \"rate_x_degps\", kind = \"sum\"}"),
              HasSubstr("sum is 8 bits of whole bytes"));
}

TEST(DbcProblems, AFaultOfChecksumsNeedsADescriptionThatNamesOne) {
  rig_config::DeviceConfig device;
  device.kind = measurement::Kind::imu;
  device.link = "can:auto";
  device.protocol = "toy.toml";
  const auto with = [](const std::string& more) {
    return test::described(
        "[sensor]\ntitle = \"t\"\nkind = \"imu\"\n[protocol]\ndbc = \"xsens.dbc\"\n"
        "[[protocol.frames]]\nmessage = \"gnss_status\"\n" +
        more + "fields = []\n" + std::string(rates_and_forces));
  };
  rig_config::FaultConfig fault;
  fault.kind = rig_config::FaultKind::bad_checksum;
  device.description = with("checksum = {signal = \"valid\", kind = \"sum\"}\n");
  EXPECT_FALSE(rig_config::refusal(fault, device));
  device.description = with("");
  EXPECT_THAT(rig_config::refusal(fault, device).value_or(""),
              HasSubstr("its protocol has no checksum of its own; allowed: flip, truncate"));
}

}  // namespace dbc_refusal_test
}  // namespace drydock::described::test
