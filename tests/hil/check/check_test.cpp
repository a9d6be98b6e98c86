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

TEST(Check, OneBadFileDoesNotHideTheOthers) {
  const std::string demo = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  MemoryFile out;
  EXPECT_EQ(check({"/nowhere.toml", demo}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith("/nowhere.toml: cannot be read"));
  EXPECT_THAT(out.text(), HasSubstr(demo + ": ok\n"));
}

}  // namespace check_test
}  // namespace drydock::check
