#include "hil/check/check.hpp"

#include <gmock/gmock.h>

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

TEST(Check, OneBadFileDoesNotHideTheOthers) {
  const std::string demo = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  MemoryFile out;
  EXPECT_EQ(check({"/nowhere.toml", demo}, out.file()), 2);
  EXPECT_THAT(out.text(), StartsWith("/nowhere.toml: cannot be read"));
  EXPECT_THAT(out.text(), HasSubstr(demo + ": ok\n"));
}

}  // namespace check_test
}  // namespace drydock::check
