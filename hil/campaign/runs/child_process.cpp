#include "hil/campaign/runs/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>

namespace drydock::campaign {
namespace {

constexpr int not_started = 127;

void redirect(const char* path, int to) {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file >= 0) ::dup2(file, to);
}

/// Memory of the children goes first: the runner has to write down what became of them.
void be_the_first_without_memory() {
  const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  if (::write(file, "500", 3) != 3) errno = 0;  // then the kernel chooses as usual
  ::close(file);
}

/// To the errors of the run, as a shell does.
void say_why_not(const char* program) {
  for (const char* part : {"cannot start ", program, ": ", ::strerrordesc_np(errno), "\n"})
    if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) return;
}

/// Between fork and exec in a program with threads only these calls are allowed.
[[noreturn]] void become(char* const* words, const char* output, const char* errors, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(not_started);
  be_the_first_without_memory();
  redirect("/dev/null", STDIN_FILENO);
  redirect(output, STDOUT_FILENO);
  redirect(errors, STDERR_FILENO);
  ::execvp(words[0], words);
  say_why_not(words[0]);
  ::_exit(not_started);
}

pid_t started(const Child& child) {
  std::vector<char*> words;
  for (const auto& word : child.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) become(words.data(), child.output.c_str(), child.errors.c_str(), parent);
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "cannot start a run");
  ::setpgid(pid, pid);  // whoever comes first
  return pid;
}

bool asks_to_end(int signal) { return signal == SIGTERM || signal == SIGINT || signal == SIGHUP; }

/// Reaps the program after what it left running was ended. The group lives as long as its leader
/// is not reaped, so the number cannot mean another.
ChildEnd reaped(pid_t pid, Ended how) {
  siginfo_t end{};
  if (how != Ended::by_itself) ::kill(-pid, SIGKILL);
  while (::waitid(P_PID, static_cast<id_t>(pid), &end, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  ::kill(-pid, SIGKILL);
  while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
  if (how == Ended::by_itself && end.si_code != CLD_EXITED)
    how = asks_to_end(end.si_status) ? Ended::from_outside : Ended::by_signal;
  return {how, end.si_status};
}

}  // namespace

ChildEnd run_child(const Child& child, const std::function<bool()>& stopped) {
  using Clock = std::chrono::steady_clock;
  constexpr int look_ms = 100;
  const auto begin = Clock::now();
  const pid_t pid = started(child);
  const int handle = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
  if (handle < 0) return reaped(pid, Ended::by_itself);  // an old kernel: wait without looking
  pollfd end{handle, POLLIN, 0};
  Ended how = Ended::by_itself;
  while (::poll(&end, 1, look_ms) <= 0 && how == Ended::by_itself) {
    const std::chrono::duration<double> took = Clock::now() - begin;
    if (stopped())
      how = Ended::from_outside;
    else if (child.timeout_s > 0 && took.count() > child.timeout_s)
      how = Ended::by_timeout;
  }
  ::close(handle);
  return reaped(pid, how);
}

}  // namespace drydock::campaign
