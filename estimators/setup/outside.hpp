#pragma once

#include <functional>
#include <string>

namespace drydock::setup {

/// How a run reaches estimators in other programs.
struct Outside {
  using Say = std::function<void(const std::string& line)>;

  bool lockstep = false;  ///< virtual time waits for each answer
  Say say = {};           ///< gets lines for a person; may be empty
};

}  // namespace drydock::setup
