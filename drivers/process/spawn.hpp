#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace drydock::process {

/// A started program and this side's ends of its standard input and output.
struct Spawned {
  pid_t pid = -1;
  int in = -1, out = -1;
  std::string problem;  ///< empty: it started
};

/// `folder` is the program's working folder, empty: this program's.
Spawned spawn(const std::vector<std::string>& command, const std::string& folder);

}  // namespace drydock::process
