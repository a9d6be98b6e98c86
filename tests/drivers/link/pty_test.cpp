#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/serial/line_settings.hpp"
#include "tests/drivers/link/running.hpp"

namespace drydock::link::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Pty : public ::testing::Test {
 protected:
  Folder folder;
  std::string path = folder.file("dvl");
  std::string uri = "pty:" + path + "?baud=38400";
  asio::io_context io;
};

TEST_F(Pty, StandsUnderAStableNameThatGoesWithIt) {
  auto device = open(io, uri, Side::device);
  EXPECT_TRUE(fs::is_character_file(path));
  EXPECT_THAT(fs::read_symlink(path).string(), HasSubstr("/dev/pts/"));
  device->close();
  EXPECT_FALSE(fs::is_symlink(path));
}

TEST_F(Pty, WithoutACloseTheNameGoesWithTheLink) {
  { const auto device = open(io, uri, Side::device); }
  EXPECT_FALSE(fs::is_symlink(path));
}

TEST_F(Pty, ShortNamesStandInThePrivateRuntimeFolder) {
  ::setenv("XDG_RUNTIME_DIR", folder.file("").c_str(), 1);
  const auto device = open(io, "pty:gnss", Side::device);
  const fs::path expected =
      fs::path(folder.file("")) / ("drydock-" + std::to_string(::getuid())) / "gnss";
  EXPECT_TRUE(fs::is_character_file(expected));
  EXPECT_EQ(fs::status(expected.parent_path()).permissions() & fs::perms::all,
            fs::perms::owner_all);
  ::unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(pty_path("gnss"), "/tmp/drydock-" + std::to_string(::getuid()) + "/gnss");
}

TEST_F(Pty, ItsNameStandsInNoFolderThatOthersMayWriteTo) {
  const fs::path open_to_all = folder.file("shared");
  fs::create_directory(open_to_all);
  const std::string inside = "pty:" + (open_to_all / "dvl").string();
  ASSERT_EQ(::chmod(open_to_all.c_str(), 0777), 0);
  const auto refused = open_bytes(io.get_executor(), parse_uri(inside).value(), Side::device);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("which others may write to"));
  ASSERT_EQ(::chmod(open_to_all.c_str(), 01777), 0);  // as /tmp: only its owner may change a name
  EXPECT_TRUE(open_bytes(io.get_executor(), parse_uri(inside).value(), Side::device));
  if (::getuid() != 0) return;
  constexpr uid_t somebody_else = 12345;
  ASSERT_EQ(::chown(open_to_all.c_str(), somebody_else, somebody_else), 0);
  EXPECT_FALSE(open_bytes(io.get_executor(), parse_uri(inside).value(), Side::device));
}

/// Anybody may make a name under /tmp before us.
TEST_F(Pty, ItsPrivateFolderIsNoPlantedLinkAndNobodyElses) {
  ::setenv("XDG_RUNTIME_DIR", folder.file("").c_str(), 1);
  const fs::path place = fs::path(pty_path("dvl")).parent_path();
  const fs::path elsewhere = folder.file("elsewhere");
  const auto refusal = [&] {
    const auto opened = open_bytes(io.get_executor(), parse_uri("pty:dvl").value(), Side::device);
    return opened ? std::string() : opened.error().message;
  };
  fs::create_directory(elsewhere);
  fs::create_directory_symlink(elsewhere, place);
  EXPECT_EQ(refusal(), place.string() +
                           " is a symbolic link; remove it, or set XDG_RUNTIME_DIR "
                           "to a folder of your own");
  EXPECT_TRUE(fs::is_empty(elsewhere));
  fs::remove(place);
  fs::create_directory(place);
  ASSERT_EQ(::chmod(place.c_str(), 0770), 0);
  EXPECT_THAT(refusal(), HasSubstr("may be written by others"));
  ASSERT_EQ(::chmod(place.c_str(), 0700), 0);
  EXPECT_EQ(refusal(), "");
  if (::getuid() == 0) {
    ASSERT_EQ(::chown(place.c_str(), 12345, 12345), 0);
    EXPECT_THAT(refusal(), HasSubstr("belongs to another user"));
  }
  ::setenv("XDG_RUNTIME_DIR", folder.file("nowhere").c_str(), 1);
  EXPECT_THAT(refusal(), HasSubstr("No such file or directory; set XDG_RUNTIME_DIR to a folder"));
  ::unsetenv("XDG_RUNTIME_DIR");
}

TEST_F(Pty, NeverReplacesAFileOfAnotherKind) {
  std::ofstream(path) << "precious";
  const auto device = open_bytes(io.get_executor(), parse_uri(uri).value(), Side::device);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().message,
            path + " exists and is no symbolic link: it will not be replaced");
  EXPECT_TRUE(fs::is_regular_file(path));
}

TEST_F(Pty, ReplacesTheNameThatACrashLeftBehind) {
  fs::create_symlink("/dev/pts/99999", path);
  const auto device = open(io, uri, Side::device);
  EXPECT_TRUE(fs::is_character_file(path));
}

/// Two benches of one rig: the second must not take the vehicle of the first from its autopilot.
TEST_F(Pty, NeverTakesTheNameOfADeviceThatLives) {
  auto first = open(io, uri, Side::device);
  const auto owner = fs::read_symlink(path);
  const auto second = open_bytes(io.get_executor(), parse_uri(uri).value(), Side::device);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            path +
                " is a device of another program that runs; end that one, or give this device "
                "another name");
  EXPECT_EQ(fs::read_symlink(path), owner);
  first->close();
  EXPECT_TRUE(open_bytes(io.get_executor(), parse_uri(uri).value(), Side::device));
}

TEST_F(Pty, LeavesANameAloneThatIsNoLongerItsOwn) {
  auto device = open(io, uri, Side::device);
  fs::remove(path);
  fs::create_symlink("/dev/null", path);
  device.reset();
  EXPECT_EQ(fs::read_symlink(path), "/dev/null");
}

TEST_F(Pty, DriverIsToldWhatIsMissing) {
  const auto driver = open_bytes(io.get_executor(), parse_uri(uri).value(), Side::driver);
  ASSERT_FALSE(driver);
  EXPECT_EQ(driver.error().message,
            "cannot open " + path + ": No such file or directory (is the device plugged in, or " +
                "the emulator running?)");
}

TEST_F(Pty, AListenerThatStopsReadingDoesNotStopTheDevice) {
  const auto device = open(io, uri, Side::device);
  const auto driver = open(io, uri, Side::driver);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(run(io, device->write(Buffer(4096, 'x')))) << i;
}

TEST_F(Pty, IsNotExclusiveSoOtherProgramsMayJoin) {
  const auto device = open(io, uri, Side::device);
  const auto driver = open(io, uri, Side::driver);
  const Descriptor other(::open(path.c_str(), O_RDWR | O_NOCTTY));
  EXPECT_TRUE(other);
}

TEST_F(Pty, SerialLinkTakesItForItselfAlone) {
  const auto device = open(io, uri, Side::device);
  const std::string serial = "serial:" + path + "?baud=9600";
  const auto first = open(io, serial, Side::driver);
  const auto second = open_bytes(io.get_executor(), parse_uri(serial).value(), Side::driver);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another program has it open"));
}

TEST_F(Pty, ProvenanceFollowsTheUri) {
  const auto device = open(io, uri, Side::device);
  EXPECT_EQ(open(io, uri, Side::driver)->provenance(), Provenance::emulated);
  const std::string serial = "serial:" + path + "?baud=9600";
  EXPECT_EQ(open(io, serial, Side::driver)->provenance(), Provenance::real);
  EXPECT_EQ(open(io, serial + "&emulated=1", Side::driver)->provenance(), Provenance::emulated);
}

// The kernel's pty keeps neither parity nor data bits: it has no line on which a byte has a frame.
TEST_F(Pty, ParityOfAPtyIsOnlyItsPaceSoEmulatedRigsWithParityRun) {
  const auto device = open(io, "pty:" + path + "?baud=4800&parity=even&stop=2", Side::device);
  const std::string serial = "serial:" + path + "?baud=4800&parity=even&stop=2&dtr=0&rs485=high";
  const auto driver = open(io, serial, Side::driver);
  ASSERT_TRUE(driver);
  ASSERT_TRUE(run(io, device->write(bytes("8E2"))));
  EXPECT_EQ(run(io, read_bytes(*driver, 3)).value(), bytes("8E2"));
}

class AnyBaud : public ::testing::TestWithParam<unsigned> {};

TEST_P(AnyBaud, IsWhatTheKernelReadsBack) {
  const Folder folder;
  const std::string path = folder.file("line");
  asio::io_context io;
  const auto device = open(io, "pty:" + path, Side::device);
  const auto driver = open(io, "pty:" + path + "?baud=" + std::to_string(GetParam()), Side::driver);
  const Descriptor port(::open(path.c_str(), O_RDWR | O_NOCTTY));
  EXPECT_EQ(line_baud(port.get()).value(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Termios2, AnyBaud,
                         ::testing::Values(50U, 4800U, 38'400U, 100'000U, 115'200U, 250'000U,
                                           921'600U, 3'000'000U, 12'000'000U),
                         ::testing::PrintToStringParamName());

TEST(Serial, ADeviceThatIsNoLineIsRefused) {
  asio::io_context io;
  const auto link =
      open_bytes(io.get_executor(), parse_uri("serial:/dev/null?baud=9600").value(), Side::driver);
  ASSERT_FALSE(link);
  EXPECT_EQ(link.error().message,
            "cannot open /dev/null: Inappropriate ioctl for device (not a serial port)");
}

}  // namespace
}  // namespace drydock::link::testing
