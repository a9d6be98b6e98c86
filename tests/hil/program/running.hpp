#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/hil/program/program.hpp"
#include "tests/own_domain.hpp"

namespace program {

/// The program runs beside a test in the folder of its ptys and sockets. SIGTERM ends it.
class Running {
 public:
  Running(const Folder& folder, const std::string& arguments, const std::string& name)
      : output_(folder / name) {
    const std::string links = "XDG_RUNTIME_DIR=" + (folder / "").string(),
                      domain = "ROS_DOMAIN_ID=" + std::to_string(drydock::test::own_domain());
    std::array environment{const_cast<char*>(links.c_str()), const_cast<char*>(domain.c_str()),
                           static_cast<char*>(nullptr)};
    std::istringstream typed(DRYDOCK_PROGRAM " " + arguments);
    std::vector<std::string> words{std::istream_iterator<std::string>(typed), {}};
    std::vector<char*> pointers;
    std::ranges::transform(words, std::back_inserter(pointers), [](auto& w) { return w.data(); });
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, DRYDOCK_SOURCE_DIR);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output_.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    const int error =
        posix_spawn(&pid_, DRYDOCK_PROGRAM, &actions, nullptr, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::system_error(error, std::generic_category());
  }
  ~Running() {
    if (!ended_) end(SIGTERM);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// True as soon as the program catches the signal. False when patience is over.
  bool catches(int signal) const {
    const auto path = "/proc/" + std::to_string(pid_) + "/status";
    for (const auto end = std::chrono::steady_clock::now() + patience;
         std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds{1})) {
      const std::string status = read_file(path);
      const auto mask = status.find("SigCgt:");
      if (mask != std::string::npos &&
          (std::stoull(status.substr(mask + 7), nullptr, 16) >> (signal - 1) & 1U) != 0)
        return true;
    }
    return false;
  }
  void tell(int signal) const { kill(pid_, signal); }
  /// Its exit code, or minus the signal that killed it.
  int end(int signal) {
    tell(signal);
    int status = 0;
    waitpid(pid_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  std::string output() const { return read_file(output_); }

  /// True as soon as it has printed the text. False when patience is over.
  bool says(const std::string& text) const {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (output().find(text) == std::string::npos) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    return true;
  }

  /// The text between `from` and the end of its line, as soon as it is printed. Empty when it is
  /// over.
  std::string line_from(const std::string& from) const {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      const auto said = output();
      const auto begin = said.find(from);
      const auto line_end = begin == std::string::npos ? begin : said.find('\n', begin);
      if (line_end != std::string::npos)
        return said.substr(begin + from.size(), line_end - begin - from.size());
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    return {};
  }

 private:
  std::filesystem::path output_;
  pid_t pid_ = 0;
  bool ended_ = false;
};

}  // namespace program
