#include "drivers/link/serial/access_advice.hpp"

#include <gmock/gmock.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace drydock::link {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A file in the place of a port: who may open it is decided alike.
class AccessAdvice : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(path_) << "x"; }
  void TearDown() override { std::filesystem::remove(path_); }
  std::string with(gid_t group, mode_t mode) const {
    EXPECT_EQ(::chown(path_.c_str(), ::geteuid(), group), 0);
    EXPECT_EQ(::chmod(path_.c_str(), mode), 0);
    return access_advice(path_);
  }
  const std::string path_ =
      (std::filesystem::temp_directory_path() / ("port-" + std::to_string(::getpid()))).string();
};

TEST_F(AccessAdvice, NobodyIsToldToJoinTheGroupRoot) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives a file to other groups";
  const auto advice = with(0, 0660);
  EXPECT_THAT(advice, Not(HasSubstr("join the group")));
  EXPECT_THAT(advice, HasSubstr("sudo chgrp dialout " + path_));
  EXPECT_THAT(advice, HasSubstr("udev rule"));
}

TEST_F(AccessAdvice, NamesTheGroupOfThePort) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives a file to other groups";
  const auto* dialout = ::getgrnam("dialout");
  ASSERT_NE(dialout, nullptr);
  EXPECT_EQ(with(dialout->gr_gid, 0660), "join the group dialout");
  EXPECT_THAT(with(dialout->gr_gid, 0600), HasSubstr("sudo chmod g+rw"));
}

}  // namespace
}  // namespace drydock::link
