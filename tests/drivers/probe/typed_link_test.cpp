#include "drivers/probe/typed_link.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace typed_link_test {

using drydock::probe::path_trouble;
using drydock::probe::typed_link;

TEST(TypedLink, AnInterfaceAndAPortNeedNoScheme) {
  EXPECT_EQ(typed_link("can0"), "socketcan:can0");
  EXPECT_EQ(typed_link("slcan12"), "socketcan:slcan12");
  EXPECT_EQ(typed_link("ttyUSB0"), "serial:/dev/ttyUSB0");
  EXPECT_EQ(typed_link("/dev/ttyACM3"), "serial:/dev/ttyACM3");
  EXPECT_EQ(typed_link("/dev/serial/by-id/usb-FTDI:1"), "serial:/dev/serial/by-id/usb-FTDI:1");
}

TEST(TypedLink, AUriStaysAsItIs) {
  for (const auto* uri : {"can:auto?name=can0", "pty:dvl", "tcp:10.0.0.1:4001", "file:a.bin"})
    EXPECT_EQ(typed_link(uri), uri);
}

TEST(TypedLink, AnInterfaceWithItsOwnNameIsFoundInSys) {
  auto name = (std::filesystem::temp_directory_path() / "drydock-sys-XXXXXX").string();
  const std::filesystem::path root = mkdtemp(name.data());
  std::filesystem::create_directories(root / "sys/class/net/hull");
  EXPECT_EQ(typed_link("hull", root), "socketcan:hull");
  EXPECT_EQ(typed_link("keel", root), "keel");
  std::filesystem::remove_all(root);
}

TEST(TypedLink, AFolderAndAFileThatIsNotThereAreNoLinks) {
  EXPECT_EQ(typed_link("."), ".");
  EXPECT_EQ(typed_link(".."), "..");
  EXPECT_NE(path_trouble(".").find("is a folder"), std::string::npos);
  EXPECT_NE(path_trouble("nonexist.log").find("there is no file"), std::string::npos);
  EXPECT_EQ(path_trouble("tcp:10.0.0.1"), "");
}

TEST(TypedLink, ThePathOfAPtyIsAPty) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ::grantpt(master);
  ::unlockpt(master);
  std::array<char, 64> path{};
  ::ptsname_r(master, path.data(), path.size());
  EXPECT_EQ(typed_link(path.data()), std::string("pty:") + path.data());
  ::close(master);
}

}  // namespace typed_link_test
