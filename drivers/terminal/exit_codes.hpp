#pragma once

namespace drydock::terminal {

/// The exit codes of every command. docs/use/run.md says the same to users.
inline constexpr int exit_success = 0;
inline constexpr int exit_failed = 1;         ///< the run or the input failed
inline constexpr int exit_usage = 2;          ///< wrong usage or configuration
inline constexpr int exit_interrupted = 130;  ///< Ctrl-C came before the verdict: 128 + SIGINT

/// 0 for a good end, 1 for a bad one.
constexpr int exit_of(bool good) { return good ? exit_success : exit_failed; }

/// The codes for the help of the program.
inline constexpr const char* exit_codes_help =
    "Exit codes: 0 success, 1 the run or the input failed, 2 wrong usage or configuration, 130 "
    "Ctrl-C before the verdict.";

}  // namespace drydock::terminal
