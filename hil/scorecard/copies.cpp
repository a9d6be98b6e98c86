#include "hil/scorecard/copies.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

namespace drydock::scorecard {
namespace {

using Run = std::function<std::string(std::size_t)>;

constexpr int done = 0, threw = 1, unheard = 2;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The life of a copy. It ends without the destructors and exit handlers of its original.
[[noreturn]] void live(const Run& run, std::size_t k, int to, pid_t original) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != original) ::_exit(unheard);
  int end = done;
  std::string said;
  try {
    said = run(k);
  } catch (const std::exception& error) {
    said = error.what();
    end = threw;
  }
  ::_exit(write_all(to, said) ? end : unheard);
}

/// A run in a copy of this process.
class Copy {
 public:
  Copy(const Run& run, std::size_t k) : k_(k) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail("a run cannot begin");
    const pid_t original = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) live(run, k, pipe[1], original);
    ::close(pipe[1]);
    from_ = pipe[0];
    if (pid_ < 0) {
      ::close(from_);
      fail("a run cannot begin");
    }
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  ~Copy() {
    ::close(from_);
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    wait();
  }

  std::size_t run() const { return k_; }
  int handle() const { return from_; }

  /// Reads what has come. True: that was all.
  bool read() {
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(from_, bytes.data(), bytes.size());
    if (count > 0) said_.append(bytes.data(), static_cast<std::size_t>(count));
    return count == 0 || (count < 0 && errno != EINTR);
  }

  std::string outcome() {
    const int status = wait();
    pid_ = -1;
    if (WIFSIGNALED(status))
      throw std::runtime_error(fmt::format("run {} was ended by {} (signal {})", k_,
                                           ::strsignal(WTERMSIG(status)), WTERMSIG(status)));
    if (WEXITSTATUS(status) == threw) throw std::runtime_error(said_);
    if (WEXITSTATUS(status) != done) throw std::runtime_error(fmt::format("run {} was lost", k_));
    return std::move(said_);
  }

 private:
  int wait() const {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
  }

  std::size_t k_;
  pid_t pid_ = -1;
  int from_ = -1;
  std::string said_;
};

/// Waits until one or more of them say something.
std::vector<pollfd> heard_from(const std::vector<std::unique_ptr<Copy>>& copies) {
  std::vector<pollfd> handles;
  handles.reserve(copies.size());
  for (const auto& copy : copies) handles.push_back({copy->handle(), POLLIN, 0});
  if (::poll(handles.data(), handles.size(), -1) < 0 && errno != EINTR) fail("runs are not heard");
  return handles;
}

}  // namespace

std::size_t in_copies(std::string_view name, const study::Options& options,
                      study::Progress& progress, const Run& run,
                      const std::function<void(std::string&&)>& collect) {
  const std::size_t jobs = std::max(options.jobs, 1U);
  std::size_t begun = 0, collected = 0;
  std::vector<std::unique_ptr<Copy>> copies;
  std::map<std::size_t, std::string> early;  // finished before a run with a lower number
  for (;;) {
    while (copies.size() < jobs && begun < options.runs && !progress.stopped())
      copies.push_back(std::make_unique<Copy>(run, begun++));
    if (copies.empty()) return collected;
    const auto handles = heard_from(copies);
    for (std::size_t i = copies.size(); i-- > 0;) {
      if (handles[i].revents == 0 || !copies[i]->read()) continue;
      early.emplace(copies[i]->run(), copies[i]->outcome());
      copies.erase(copies.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (; !early.empty() && early.begin()->first == collected; early.erase(early.begin())) {
      collect(std::move(early.begin()->second));
      progress.on_run(name, ++collected, options.runs);
    }
  }
}

}  // namespace drydock::scorecard
