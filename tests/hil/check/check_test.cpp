#include "hil/check/check.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "tests/drivers/decode/captured.hpp"

namespace drydock::check {
namespace check_test {

using decode::MemoryFile;
using decode::TemporaryFile;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Check, SoundFilesAreOk) {
  const std::string rigs = DRYDOCK_SOURCE_DIR "/rig_config/rigs/";
  MemoryFile out;
  EXPECT_EQ(check({rigs + "demo.toml", rigs + "bench-serial.toml"}, out.file()), 0);
  EXPECT_EQ(out.text(), rigs + "demo.toml: ok\n" + rigs + "bench-serial.toml: ok\n");
}

TEST(Check, ABadLinkIsALineOfItsFile) {
  const TemporaryFile rig(
      "[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
      "link = \"pty:dvl?bauds=9600\"\n");
  MemoryFile out;
  EXPECT_EQ(check({rig.path()}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith(rig.path() + ":7:8: /device/0/link: "));
  EXPECT_THAT(out.text(), HasSubstr("bauds"));
}

struct NamedFile {
  std::string path;
  NamedFile(const std::string& name, std::string_view text)
      : path(testing::TempDir() + std::to_string(::getpid()) + name) {
    std::ofstream(path) << text;
  }
  ~NamedFile() { std::remove(path.c_str()); }
};

TEST(Check, ADbcFileIsReadAsOne) {
  const NamedFile good("good.dbc",
                       "BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1,0) [0|0] \"\" n\n"
                       " SG_ t : 4|8@1+ (1,0) [0|0] \"\" n\n");
  const NamedFile bad("bad.dbc", "BO_ 1 a: 8 n\n SG_ s : 0|99@1+ (1,0) [0|0] \"\" n\n");
  MemoryFile out;
  EXPECT_EQ(check({good.path}, out.file()), 0);
  EXPECT_THAT(out.text(), HasSubstr(good.path + ":3:6: warning: signal t shares bits with s\n" +
                                    good.path + ": ok, 1 messages\n"));
  EXPECT_EQ(check({bad.path, "/nowhere.dbc"}, out.file()), 2);
  EXPECT_THAT(out.text(), HasSubstr(bad.path + ":2:12: the number of bits is beyond 1 to 64\n"));
  EXPECT_THAT(out.text(), HasSubstr("/nowhere.dbc: "));
}

/// A rig with one emulated device on a line at 9600 baud, which carries 960 bytes a second.
std::string rig_at_9600_baud(const std::string& device) {
  return "[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\nlink = \"pty:line?baud=9600\"\n" + device;
}

// An epoch of RMC, GGA, VTG, GSA, ZDA and three or four GSV has between 320 and 480 bytes, so the
// line carries two a second.
TEST(Check, SaysBeforehandThatALineCannotCarryItsSentences) {
  const std::string receiver = "kind = \"gnss\"\nprotocol = \"nmea0183\"\nrate_hz = ";
  const TemporaryFile fast(rig_at_9600_baud(receiver + "5\n")),
      slow(rig_at_9600_baud(receiver + "1\n"));
  MemoryFile out;
  EXPECT_EQ(check({fast.path()}, out.file()), 0);
  EXPECT_THAT(out.text(), StartsWith(fast.path() + ":5:8: /device/0/link: warning: the emulated "
                                                   "device sends "));
  EXPECT_THAT(out.text(), HasSubstr(" bytes a second and the line carries 960, so samples are "
                                    "lost; what fits: baud=38400 or rate_hz = 2\n"));
  EXPECT_THAT(out.text(), HasSubstr(fast.path() + ": ok\n"));
  EXPECT_EQ(check({slow.path()}, out.file()), 0);
  EXPECT_THAT(out.text(), testing::EndsWith(": ok\n" + slow.path() + ": ok\n"));
}

// A log sends VBW and VHW, between 60 and 120 bytes: eight a second fit, sixteen do not.
TEST(Check, SaysThatDevicesOnOneLineAreTooMuchForIt) {
  const std::string log = "kind = \"emlog\"\nprotocol = \"nmea0183\"\nrate_hz = 8\n";
  const TemporaryFile one(rig_at_9600_baud(log)),
      two(rig_at_9600_baud(log) + "[[device]]\nname = \"e\"\nlink = \"pty:line?baud=9600\"\n" +
          log);
  MemoryFile out;
  EXPECT_EQ(check({one.path()}, out.file()), 0);
  EXPECT_EQ(out.text(), one.path() + ": ok\n");
  EXPECT_EQ(check({two.path()}, out.file()), 0);
  EXPECT_THAT(out.text(), HasSubstr("warning: what is emulated on this line sends "));
}

TEST(Check, OneBadFileDoesNotHideTheOthers) {
  const std::string demo = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  MemoryFile out;
  EXPECT_EQ(check({"/nowhere.toml", demo}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith("/nowhere.toml: cannot be read"));
  EXPECT_THAT(out.text(), HasSubstr(demo + ": ok\n"));
}

}  // namespace check_test
}  // namespace drydock::check
