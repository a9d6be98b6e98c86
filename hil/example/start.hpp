#pragma once

#include <cstdio>
#include <string>

namespace drydock::example {

struct StartOptions {
  std::string kind;        ///< rig, mission, sensor or vehicle
  std::string name;        ///< of the thing; the file is NAME.toml
  bool overwrite = false;  ///< replace what is there
};

/// Writes NAME.toml, a commented start that `drydock check` accepts. Returns the exit code.
int start(const StartOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::example
