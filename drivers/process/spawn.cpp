#include "drivers/process/spawn.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace drydock::process {
namespace {

/// What the new program does before it begins: its files, its folder, its signals.
class Preparations {
 public:
  Preparations(int in, int out, const std::string& folder) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_adddup2(&files_, in, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, out, STDOUT_FILENO);
    if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&files_, folder.c_str());
    ::posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Preparations() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&files_);
  }
  Preparations(const Preparations&) = delete;
  Preparations& operator=(const Preparations&) = delete;

  int spawn(pid_t& pid, const std::vector<std::string>& command) const {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return ::posix_spawnp(&pid, arguments[0], &files_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

// The input is a socket, because a write to a closed socket need not raise SIGPIPE.
Spawned spawn(const std::vector<std::string>& command, const std::string& folder) {
  int input[2], output[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input) != 0)
    return {.problem = std::strerror(errno)};
  if (::pipe2(output, O_CLOEXEC) != 0) {
    ::close(input[0]), ::close(input[1]);
    return {.problem = std::strerror(errno)};
  }
  Spawned spawned{.in = input[0], .out = output[0], .problem = {}};
  const int error = Preparations(input[1], output[1], folder).spawn(spawned.pid, command);
  ::close(input[1]), ::close(output[1]);
  if (error == 0) {
    ::fcntl(spawned.in, F_SETFL, O_NONBLOCK);
    ::fcntl(spawned.out, F_SETFL, O_NONBLOCK);
    return spawned;
  }
  ::close(input[0]), ::close(output[0]);
  return {.problem = fmt::format("cannot start {}: {}", command[0], std::strerror(error))};
}

}  // namespace drydock::process
