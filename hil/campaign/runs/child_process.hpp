#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace drydock::campaign {

/// From outside: we were stopped, or somebody asked the program itself to end (SIGTERM, SIGINT,
/// SIGHUP), as Slurm does with all programs of a task that is cancelled.
enum class Ended : std::uint8_t { by_itself, by_signal, by_timeout, from_outside };

struct ChildEnd {
  Ended how = Ended::by_itself;
  int code = 0;  ///< exit code, or the number of the signal
};

struct Child {
  std::vector<std::string> words;  ///< program and arguments; a program without '/' is looked up
  std::filesystem::path output, errors;  ///< files for what it prints
  double timeout_s = 0;                  ///< 0: none
};

/// Runs a program to its end. It has a process group of its own, so a Ctrl-C of the terminal does
/// not reach it; whatever it leaves running ends with it. `stopped` is asked ten times a second;
/// true ends the program at once. The kernel ends it too if the calling thread ends, and takes it
/// before us if memory runs out. An exit code of 127: it could not be started.
ChildEnd run_child(const Child& child, const std::function<bool()>& stopped);

}  // namespace drydock::campaign
