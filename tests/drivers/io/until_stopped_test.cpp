#include "drivers/io/until_stopped.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "drivers/terminal/interrupt_flag.hpp"

namespace until_stopped_test {

using drydock::io::UntilStopped;

/// Counts the calls of `stop` until there is no work left.
struct Program {
  boost::asio::io_context io;
  int stops = 0;
  UntilStopped until;
  explicit Program(double duration_s) : until(io, duration_s, [this] { ++stops; }) {}
};

TEST(UntilStopped, EndsWhenTheTimeIsOver) {
  Program program(0.001);
  program.io.run();
  EXPECT_EQ(program.stops, 1);
  EXPECT_FALSE(program.until.interrupted());
}

TEST(UntilStopped, EndsAtCtrlCWithoutWaitingForTheTime) {
  Program program(3600);
  std::raise(SIGINT);
  program.io.run();
  EXPECT_EQ(program.stops, 1);
  EXPECT_TRUE(program.until.interrupted());
}

// A program makes its links between the first and the second, and the signal comes meanwhile.
TEST(UntilStopped, EndsAtASignalThatAFlagCaughtBefore) {
  for (const double duration_s : {0.0, 3600.0}) {
    const drydock::terminal::InterruptFlag flag;
    std::raise(SIGTERM);
    Program program(duration_s);
    program.io.run();
    EXPECT_EQ(program.stops, 1);
    EXPECT_TRUE(program.until.interrupted());
  }
}

TEST(UntilStopped, WithoutATimeEndsAtTheSignalAlone) {
  Program program(0);
  EXPECT_EQ(program.io.poll(), 0u);
  std::raise(SIGTERM);
  program.io.run();
  EXPECT_EQ(program.stops, 1);
}

// A shell and the kernel both send one when an ssh session drops.
TEST(UntilStopped, EndsAtAHangupAndASecondHangupDoesNotDisturbTheEnd) {
  EXPECT_EXIT(
      {
        Program program(0);
        std::raise(SIGHUP);
        program.io.run();
        std::raise(SIGHUP);
        std::exit(program.stops == 1 && program.until.interrupted() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

/// In a program of its own, which begins as one under nohup does.
void run_under_nohup(bool (*survives)()) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        std::exit(survives() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(UntilStopped, AHangupThatIsIgnoredAtTheStartEndsNeitherThisNorTheNextRun) {
  run_under_nohup([] {
    for (int run = 1; run <= 2; ++run) {
      Program program(0);
      std::raise(SIGHUP);
      program.io.poll();
      if (program.stops != 0) return false;
      std::raise(SIGTERM);
      program.io.run();
      if (program.stops != 1) return false;
    }
    return true;
  });
}

TEST(InterruptFlag, AHangupThatIsIgnoredAtTheStartSetsNoFlag) {
  run_under_nohup([] {
    const drydock::terminal::InterruptFlag flag;
    std::raise(SIGHUP);
    return !flag.set();
  });
}

// As `drydock record ... | tee log` whose tee was ended: the recording is ended well.
TEST(UntilStopped, EndsWellWhenNobodyReadsWhatItPrints) {
  EXPECT_EXIT(
      {
        int ends[2];
        if (::pipe(ends) != 0 || ::dup2(ends[1], STDOUT_FILENO) < 0) std::exit(2);
        ::close(ends[0]);
        Program program(0);
        bool failed = ::write(STDOUT_FILENO, "x", 1) < 0;
        program.io.run();
        failed = failed && ::write(STDOUT_FILENO, "x", 1) == 1;  // to /dev/null now
        std::exit(failed && program.stops == 1 && program.until.interrupted() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(UntilStopped, StopsOnceWhoeverTellsIt) {
  Program program(0.001);
  program.until.stop();
  program.until.stop();
  program.io.run();
  EXPECT_EQ(program.stops, 1);
}

// Ctrl-C can end a program that hangs, with the exit code of every program that a signal ended.
TEST(UntilStopped, ASecondCtrlCEndsTheProgramAtOnce) {
  EXPECT_EXIT(
      {
        Program program(0);
        program.until.stop();
        std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace until_stopped_test
