#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "tests/own_domain.hpp"

/// Runs the program as a person or a script does.
namespace program {

/// Patience with a busy machine: nothing waits so long unless it fails.
inline constexpr std::chrono::seconds patience{60};

struct Outcome {
  int exit_code = -1;
  std::string output;  ///< standard output and standard error
};

/// A temporary folder; the destructor removes it.
class Folder {
 public:
  Folder() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;  // a program that just ends removes its own names from it
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& file) const { return path_ / file; }

 private:
  std::filesystem::path path_;
};

/// `environment`: assignments for this program alone, as a shell takes them.
inline Outcome drydock(const std::string& arguments, const std::string& environment = {}) {
  const Folder links;  // its own ptys, so that another run on this machine does not matter
  const std::string command =
      "cd " DRYDOCK_SOURCE_DIR "; export XDG_RUNTIME_DIR=" + (links / "").string() +
      " ROS_DOMAIN_ID=" + std::to_string(drydock::test::own_domain()) + "; " + environment +
      " " DRYDOCK_PROGRAM " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe)) {
    outcome.output.append(chunk.data(), n);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A part of a command line: it waits until the program that began before has this name in the
/// folder of its ptys.
inline std::string until_linked(const std::string& name) {
  return "for tenth in $(seq 600); do test -e $XDG_RUNTIME_DIR/drydock-*/" + name +
         " && break; sleep 0.1; done; ";
}

/// Begins a command line: emulates the demo rig's sensors, to the end of the line, and starts the
/// program beside them. The control socket is the last name that the emulator makes.
inline const std::string emulated_demo =
    "emulate rig_config/rigs/demo.toml > /dev/null & emulator=$!; "
    "trap 'kill $emulator; wait $emulator' EXIT; " +
    until_linked("demo.control") + DRYDOCK_PROGRAM " ";

}  // namespace program
