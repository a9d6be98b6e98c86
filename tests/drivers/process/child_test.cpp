#include "drivers/process/child.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <string>

namespace drydock::process {
namespace child_test {

using std::chrono::seconds;

constexpr std::chrono::seconds long_enough{20};

TEST(Child, GivesBackTheLinesThatCatIsSent) {
  Child cat({"cat"}, "");
  cat.send("first");
  cat.send("");
  cat.send("a third with \"quotes\"");
  EXPECT_EQ(cat.line(long_enough), "first");
  EXPECT_EQ(cat.line(long_enough), "");
  EXPECT_EQ(cat.line(long_enough), "a third with \"quotes\"");
  EXPECT_EQ(cat.line(seconds{0}), std::nullopt);
  EXPECT_FALSE(cat.closed());
}

TEST(Child, ALineLargerThanAnyPipeGoesThroughWithoutABlock) {
  const std::string large(3'000'000, 'x');
  Child cat({"cat"}, "");
  cat.send(large);
  const auto line = cat.line(long_enough);
  ASSERT_TRUE(line);
  EXPECT_EQ(*line, large);
  EXPECT_EQ(cat.unsent(), 0U);
}

TEST(Child, SaysTheExitCodeOfAProgramThatEnds) {
  Child child({"sh", "-c", "echo last words; exit 3"}, "");
  EXPECT_EQ(child.line(long_enough), "last words");
  EXPECT_EQ(child.line(long_enough), std::nullopt);
  EXPECT_TRUE(child.closed());
  EXPECT_EQ(child.ended(), "exited with code 3");
}

TEST(Child, SaysTheSignalOfAProgramThatIsKilled) {
  Child child({"sh", "-c", "kill -SEGV $$"}, "");
  EXPECT_EQ(child.line(long_enough), std::nullopt);
  EXPECT_EQ(child.ended(), "was killed by signal 11 (Segmentation fault)");
}

TEST(Child, SaysThatAProgramDoesNotExist) {
  Child child({"./there-is-no-such-program"}, "");
  EXPECT_TRUE(child.closed());
  EXPECT_EQ(child.ended(), "cannot start ./there-is-no-such-program: No such file or directory");
  child.send("nobody hears this");
  EXPECT_EQ(child.line(seconds{1}), std::nullopt);
}

TEST(Child, RunsInTheGivenFolder) {
  Child child({"pwd"}, "/usr");
  EXPECT_EQ(child.line(long_enough), "/usr");
}

TEST(Child, EndsWithItsInputWhenItIsDropped) {
  const std::string mark = testing::TempDir() + "drydock-child-" + std::to_string(getpid());
  { Child child({"sh", "-c", "cat > /dev/null; touch " + mark}, ""); }
  EXPECT_EQ(::access(mark.c_str(), F_OK), 0) << "it had time to end by itself";
  ::unlink(mark.c_str());
}

TEST(Child, IsKilledWithItsOwnChildrenIfItDoesNotEnd) {
  pid_t inner = 0;
  {
    Child child({"sh", "-c", "sleep 1000 & echo $!; wait"}, "");
    const auto line = child.line(long_enough);
    ASSERT_TRUE(line);
    inner = std::stoi(std::string(*line));
    EXPECT_EQ(::kill(inner, 0), 0);
    child.kill();
  }
  for (int i = 0; i < 2000 && ::kill(inner, 0) == 0; ++i) ::usleep(1000);  // init reaps it
  EXPECT_NE(::kill(inner, 0), 0);
}

}  // namespace child_test
}  // namespace drydock::process
