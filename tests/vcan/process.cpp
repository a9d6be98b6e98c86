#include "tests/vcan/process.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace drydock::vcan {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto bound = std::chrono::seconds{20};

int count_of(const std::string& text, const std::string& in) {
  int count = 0;
  for (std::size_t at = in.find(text); at != std::string::npos; at = in.find(text, at + 1)) ++count;
  return count;
}

}  // namespace

std::string interface() {
  const char* name = std::getenv("DRYDOCK_CAN");
  return name != nullptr ? name : "vcan0";
}

Process::Process(const std::vector<std::string>& command) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) std::abort();
  std::vector<char*> arguments;
  std::vector<std::string> words = command;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
}

Process::~Process() {
  if (pid_ > 0) {
    ::kill(pid_, SIGINT);
    wait();
  }
  ::close(pipe_);
}

std::string Process::output_until(const std::string& text, int count) {
  const auto end = Clock::now() + bound;
  while (count_of(text, output_) < count && Clock::now() < end) {
    pollfd ready{pipe_, POLLIN, 0};
    if (::poll(&ready, 1, 100) <= 0) continue;
    std::array<char, 4096> buffer;
    const ssize_t size = ::read(pipe_, buffer.data(), buffer.size());
    if (size <= 0) break;
    output_.append(buffer.data(), static_cast<std::size_t>(size));
  }
  return output_;
}

int Process::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int run_program(const std::vector<std::string>& command) { return Process(command).wait(); }

int receiver_count(const std::string& name) {
  int count = 0;
  std::ifstream list("/proc/net/can/rcvlist_all");
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    count += first == name;
  }
  return count;
}

bool wait_for_receivers(const std::string& name, int at_least) {
  const auto end = Clock::now() + bound;
  while (receiver_count(name) < at_least) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  return true;
}

}  // namespace drydock::vcan
