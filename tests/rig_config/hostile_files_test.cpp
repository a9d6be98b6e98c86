// Hostile configuration files: the loader refuses them with one line, in bounded time and memory.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/rig_config/problems.hpp"

namespace drydock::rig_config::test {
namespace hostile_files_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string repeated(std::size_t count, std::string_view what) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += what;
  return text;
}

std::string first_problem(const Problems& problems) { return to_string(problems.front()); }

TEST(HostileText, TablesInTablesTakeNoStack) {
  EXPECT_THAT(problems_of("x" + repeated(200'000, ".x") + " = 1\n"),
              ElementsAre("r.toml:8:1: /: a key of more than 16 parts"));
  EXPECT_THAT(problems_of("[a" + repeated(200'000, ".\"b\"") + "]\n"),
              ElementsAre("r.toml:8:1: /: a key of more than 16 parts"));
  EXPECT_THAT(problems_of("x = " + repeated(100'000, "[") + "\n"),
              ElementsAre("r.toml:8:1: /: more than 32 brackets in brackets"));
  EXPECT_THAT(problems_of("x = " + repeated(200, "{a.b.c.d.e.f.g.h.i.j.k=[\n")),
              ElementsAre(HasSubstr("more than 32 brackets in brackets")));
}

TEST(HostileText, DotsAndBracketsInsideStringsAndCommentsAreNone) {
  const std::string inside = repeated(100, ".x[{");
  const auto problems =
      problems_of("# " + inside + "\nestimator = [] # \"\n[[expect]]\nname = \"a\\\"" + inside +
                  "\"\ndevice = '''" + inside + "\n" + inside + "''''\n");
  EXPECT_THAT(problems, testing::Not(Contains(HasSubstr("brackets in brackets"))));
  EXPECT_THAT(problems, testing::Not(Contains(HasSubstr("parts"))));
}

TEST(HostileText, SizesAreBounded) {
  EXPECT_THAT(problems_of("# " + repeated(1u << 20, "x")),
              ElementsAre(HasSubstr("allowed: up to 1048576")));
  EXPECT_THAT(problems_of("x = \"" + repeated(100'000, "x") + "\"\n"),
              Contains(HasSubstr("a text of 100000 characters, allowed: up to 4096")));
  EXPECT_THAT(problems_of(repeated(1000, "x") + " = 1\n"),
              Contains(HasSubstr("a key of more than 128 characters")));
}

TEST(HostileText, NumbersAndTimesStayWhereTheyCanBeCalculatedWith) {
  for (const char* number : {"1e308", "-1e300", "inf", "nan"})
    EXPECT_THAT(problems_of("rate_hz = " + std::string(number) + "\n"), SizeIs(1)) << number;
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = 9999-12-31T23:59:59Z\n"),
              Contains(HasSubstr("allowed: the years 1970 to 2200")));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = 0001-01-01T00:00:00Z\n"),
              Contains(HasSubstr("allowed: the years 1970 to 2200")));
}

TEST(HostileText, OneMegabyteOfDevicesIsRefusedWithSomeOfItsProblems) {
  const auto many = problems_of(repeated(90'000, "[[device]]\n"));
  EXPECT_THAT(many, Contains(HasSubstr("/device: has 90001 values, allowed: 1 to 256")));
  EXPECT_LT(many.size(), 1000U);
}

class HostileFile : public testing::Test {
 protected:
  HostileFile() { std::filesystem::create_directories(folder_); }
  ~HostileFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("drydock-hostile-" + std::to_string(::getpid()));
};

TEST_F(HostileFile, ADeviceOrAPipeIsNoFile) {
  const auto pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {std::string("/dev/zero"), pipe, folder_.string()}) {
    const auto rig = load_rig(path);
    ASSERT_FALSE(rig) << path;
    EXPECT_THAT(first_problem(rig.error()), HasSubstr("not a file")) << path;
  }
}

TEST_F(HostileFile, TheSameHoldsForFilesThatAFileNames) {
  const auto rig = load_rig(write(
      "rig.toml", std::string(rig_table) + "mission = \"/dev/zero\"\n" + std::string(dvl_table)));
  ASSERT_FALSE(rig);
  EXPECT_THAT(first_problem(rig.error()), HasSubstr("there is no file"));
}

TEST_F(HostileFile, OneThatNamesItselfIsOfTheWrongKind) {
  const auto rig = load_rig(write("rig.toml", std::string(rig_table) + "mission = \"rig.toml\"\n" +
                                                  std::string(dvl_table) +
                                                  "[device.emulate]\nerrors = \"rig.toml\"\n"));
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()), ElementsAre(HasSubstr("expected a mission file"),
                                                 HasSubstr("expected a sensor file")));
  const auto mission = load_mission(write(
      "mission.toml",
      "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\nvehicle = \"mission.toml\"\n"
      "[[leg]]\nkind = \"straight\"\nduration_s = 5\n"));
  ASSERT_FALSE(mission);
  EXPECT_THAT(first_problem(mission.error()), HasSubstr("expected a vehicle file"));
}

TEST_F(HostileFile, ALargeOneIsNotRead) {
  const auto path = write("large.toml", "");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);  // sparse: uses no disk space
  const auto rig = load_rig(path);
  ASSERT_FALSE(rig);
  EXPECT_THAT(first_problem(rig.error()), HasSubstr("has 1099511627776 bytes, allowed: up to"));
}

}  // namespace hostile_files_test
}  // namespace drydock::rig_config::test
