#pragma once

#include <array>
#include <string_view>

namespace drydock::terminal {

inline constexpr int exit_success = 0, exit_failed = 1, exit_usage = 2, exit_interrupted = 130;

/// 0 for a good end, 1 for a bad one.
constexpr int exit_of(bool good) { return good ? exit_success : exit_failed; }

struct ExitCode {
  int code;
  std::string_view meaning;
};

/// The exit codes of every command. Its help, its manual page and docs/use/run.md have this list.
inline constexpr std::array exit_codes{ExitCode{exit_success, "success"},
                                       ExitCode{exit_failed, "the run or the input failed"},
                                       ExitCode{exit_usage, "wrong usage or configuration"},
                                       ExitCode{exit_interrupted, "a signal before the end"}};

}  // namespace drydock::terminal
