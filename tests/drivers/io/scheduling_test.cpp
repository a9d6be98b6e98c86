// What happens when the kernel refuses real-time scheduling; that it grants it is tested in
// tests/ports.
#include "drivers/io/scheduling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drydock::io {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What a process without privileges and with these limits is told; run in a child, which cannot
/// get its privileges back.
std::string told_without_privileges(rlim_t memory, rlim_t priority, const Scheduling& wanted) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit locked{memory, memory}, fifo{priority, priority};
    ::setrlimit(RLIMIT_MEMLOCK, &locked);
    ::setrlimit(RLIMIT_RTPRIO, &fifo);
    constexpr uid_t nobody = 65534;
    if (::getuid() == 0 && ::setresuid(nobody, nobody, nobody) != 0) ::_exit(1);
    const auto done = claim(wanted);
    const std::string message = done ? "granted" : done.error().message;
    ::_exit(::write(ends[1], message.data(), message.size()) < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  std::string text(4096, '\0');
  text.resize(
      static_cast<std::size_t>(std::max<ssize_t>(0, ::read(ends[0], text.data(), text.size()))));
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST(Scheduling, WithoutTheRightToLockMemoryOneLineSaysWhichLimitForbidsIt) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer answers mlockall itself and locks nothing";
#endif
  EXPECT_THAT(told_without_privileges(0, 0, {}),
              AllOf(StartsWith("the kernel refuses to lock the memory: "),
                    HasSubstr("LimitMEMLOCK=infinity")));
}

TEST(Scheduling, WithoutTheRightToAPriorityOneLineSaysWhichLimitForbidsIt) {
  EXPECT_THAT(told_without_privileges(RLIM_INFINITY, 0, {.priority = 50, .cores = {}}),
              AllOf(StartsWith("the kernel refuses SCHED_FIFO at priority 50: "),
                    HasSubstr("LimitRTPRIO=99")));
}

TEST(Scheduling, ACoreThatTheMachineHasNotIsRefusedWithThoseThatItHas) {
  const std::string told =
      told_without_privileges(RLIM_INFINITY, 0, {.priority = 50, .cores = {1023}});
  EXPECT_THAT(told,
              AllOf(StartsWith("the kernel refuses these cores: "), HasSubstr("cores 0 to ")));
}

}  // namespace
}  // namespace drydock::io
