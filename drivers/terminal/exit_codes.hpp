#pragma once

namespace drydock::terminal {

/// Exit codes of every command; 0 is success. docs/use/run.md
inline constexpr int exit_failed = 1;  ///< the run or the input failed
inline constexpr int exit_usage = 2;   ///< wrong usage or configuration

}  // namespace drydock::terminal
