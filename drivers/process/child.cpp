#include "drivers/process/child.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "drivers/process/spawn.hpp"

namespace drydock::process {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr std::size_t longest_line = 16'000'000;
constexpr milliseconds to_end{1000};

std::string in_words(int status) {
  if (WIFEXITED(status)) return fmt::format("exited with code {}", WEXITSTATUS(status));
  return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                     ::strsignal(WTERMSIG(status)));
}

timespec as_timespec(nanoseconds wait) {
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(wait);
  return {.tv_sec = whole.count(), .tv_nsec = (wait - whole).count()};
}

void close_if_open(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

nanoseconds elapsed() { return std::chrono::steady_clock::now().time_since_epoch(); }

Child::Child(const std::vector<std::string>& command, const std::string& folder) {
  Spawned spawned = spawn(command, folder);
  pid_ = spawned.pid;
  in_ = spawned.in;
  out_ = spawned.out;
  ended_ = std::move(spawned.problem);
  closed_ = !ended_.empty();
}

Child::~Child() {
  close_if_open(in_);
  if (!reap(to_end)) kill();
  close_all();
}

void Child::close_all() {
  close_if_open(in_);
  close_if_open(out_);
}

void Child::send(std::string_view line) {
  if (sent_ == unsent_.size()) unsent_.clear(), sent_ = 0;
  unsent_.append(line).push_back('\n');
  write_some();
}

void Child::write_some() {
  while (in_ >= 0 && unsent() > 0) {
    const auto n = ::send(in_, unsent_.data() + sent_, unsent(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno != EAGAIN) close_if_open(in_);  // its output says how it ended
    if (n < 0) return;
    sent_ += static_cast<std::size_t>(n);
  }
}

void Child::read_some() {
  if (taken_ > 0) {
    read_.erase(0, taken_);
    taken_ = searched_ = 0;
  }
  std::array<char, 65536> chunk;  // not initialized: it is filled before it is read
  const auto n = ::read(out_, chunk.data(), chunk.size());
  if (n > 0) read_.append(chunk.data(), static_cast<std::size_t>(n));
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) closed_ = true;
  if (read_.size() <= longest_line) return;
  closed_ = true;
  ended_ = fmt::format("sent {} bytes without an end of line", read_.size());
}

std::optional<std::string_view> Child::whole_line() {
  const auto end = read_.find('\n', std::max(taken_, searched_));
  searched_ = read_.size();
  if (end == std::string::npos) return {};
  const std::string_view line{read_.data() + taken_, end - taken_};
  taken_ = searched_ = end + 1;
  return line;
}

/// True if there may be something to read.
bool Child::wait_for_io(nanoseconds wait) {
  std::array<pollfd, 2> both{{{out_, POLLIN, 0}, {in_, POLLOUT, 0}}};
  const nfds_t count = in_ >= 0 && unsent() > 0 ? 2 : 1;
  const timespec most = as_timespec(std::max(wait, nanoseconds{0}));
  if (::ppoll(both.data(), count, &most, nullptr) <= 0) return false;
  if (both[1].revents != 0) write_some();
  return both[0].revents != 0;
}

std::optional<std::string_view> Child::line(nanoseconds wait) {
  const auto until = elapsed() + wait;
  for (;;) {
    if (const auto found = whole_line()) return found;
    if (closed_) return {};
    const auto left = until - elapsed();
    if (wait_for_io(left)) {
      read_some();
    } else if (left <= nanoseconds{0}) {
      return {};
    }
  }
}

bool Child::reap(milliseconds wait) {
  constexpr milliseconds pause{2};
  for (int status = 0; pid_ > 0; wait -= pause) {
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      pid_ = -1;
      if (ended_.empty()) ended_ = in_words(status);
    } else if (wait <= milliseconds{0}) {
      return false;
    } else {
      ::poll(nullptr, 0, static_cast<int>(pause.count()));
    }
  }
  return true;
}

const std::string& Child::ended() {
  if (closed_ && ended_.empty() && !reap(to_end)) ended_ = "closed its output";
  return ended_;
}

void Child::kill() {
  if (pid_ <= 0) return;
  ::kill(-pid_, SIGKILL);
  reap(to_end);
  closed_ = true;
}

}  // namespace drydock::process
