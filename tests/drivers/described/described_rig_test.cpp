#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/drivers/described/with_head.hpp"

/// A rig names a description: where it is looked for, and what its facts allow.
namespace drydock::described::test {
namespace described_rig_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DescriptionProblems, ARigNamesADescriptionAndItsFactsDecide) {
  const auto rig = [](std::string_view protocol, std::string_view more = {}) {
    const auto loaded = rig_config::load_rig_text(
        "[rig]\nname = \"r\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\nprotocol = \"" +
            std::string(protocol) + "\"\nlink = \"pty:vat\"\n" + std::string(more),
        "r.toml");
    std::string lines;
    if (!loaded)
      for (const auto& problem : loaded.error()) lines += to_string(problem) + "\n";
    return lines;
  };
  EXPECT_THAT(rig("valeport-vat.toml"), IsEmpty());
  EXPECT_THAT(rig("nothing.toml"),
              HasSubstr("r.toml:6:12: /device/0/protocol: nothing.toml: there is no such "
                        "description; neither as a file nor among those of the program: "));
  EXPECT_THAT(rig("cerulean-dvpdl.toml"), HasSubstr("\"cerulean-dvpdl.toml\" is not allowed"));
  EXPECT_THAT(rig("valeport-vat.toml", "[[fault]]\ndevice = \"vat\"\nfault = \"bad-checksum\"\n"),
              IsEmpty());
  EXPECT_THAT(rig("digiquartz.toml", "[[fault]]\ndevice = \"vat\"\nfault = \"bad-checksum\"\n"),
              HasSubstr("its protocol has no checksum of its own"));
  EXPECT_THAT(rig("valeport-vat.toml",
                  "[[fault]]\ndevice = \"vat\"\nfault = \"clock-step\"\nseconds = 1\n"),
              HasSubstr("no time of its own clock"));
}

TEST(DescriptionProblems, AMisspelledDescriptionIsToldBesideTheRigsOtherMistakes) {
  const auto loaded = rig_config::load_rig_text(
      "[rig]\nname = \"r\"\n[[device]]\nname = \"compass\"\nkind = \"atitude\"\nprotocol = "
      "\"nmea2000\"\nlink = \"can:auto\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\n"
      "protocol = \"valport-vat.toml\"\nlink = \"pty:vat\"\n",
      "r.toml");
  ASSERT_FALSE(loaded);
  ASSERT_EQ(loaded.error().size(), 2u);
  EXPECT_THAT(to_string(loaded.error()[0]), HasSubstr("r.toml:5:8: /device/0/kind: "));
  EXPECT_THAT(to_string(loaded.error()[1]),
              HasSubstr("r.toml:11:12: /device/1/protocol: valport-vat.toml: there is no such "
                        "description (did you mean 'valeport-vat.toml'?)"));
}

TEST(DescriptionProblems, AFileBesideTheRigComesBeforeThatOfTheProgramAndIsOneOfItsFiles) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "described-beside";
  fs::create_directories(folder);
  const auto path = (folder / "r.toml").string();
  const std::string rig =
      "[rig]\nname = \"r\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\n"
      "protocol = \"valeport-vat.toml\"\nlink = \"pty:vat\"\n";
  fs::remove(folder / "valeport-vat.toml");
  EXPECT_EQ(rig_config::load_rig_text(rig, path)->files, std::vector{path});
  std::ofstream(folder / "valeport-vat.toml")
      << head
      << "[[protocol.sentences]]\nid = \"$MINE\"\nfields = [{field = \"depth_m\", unit = "
         "\"m\"}]\n";
  const auto loaded = rig_config::load_rig_text(rig, path);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->devices[0].description->plan.messages[0].name, "MINE");
  EXPECT_EQ(loaded->files, (std::vector{path, (folder / "valeport-vat.toml").string()}));
  fs::create_directories(folder / "mine");
  fs::copy_file(folder / "valeport-vat.toml", folder / "mine" / "toy.toml",
                fs::copy_options::overwrite_existing);
  auto below = rig;
  below.replace(below.find("valeport-vat"), 12, "mine/toy");
  EXPECT_TRUE(rig_config::load_rig_text(below, path)) << "a path below the rig's folder";
  std::ofstream(folder / "valeport-vat.toml") << head << "order = \"up\"\n";
  const auto wrong = rig_config::load_rig_text(rig, path);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(to_string(wrong.error().front()),
              HasSubstr("valeport-vat.toml:5:9: /protocol/order: \"up\" is not allowed"));
}

}  // namespace described_rig_test
}  // namespace drydock::described::test
