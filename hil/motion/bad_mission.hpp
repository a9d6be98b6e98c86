#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace drydock::motion {

/// A mission that is not possible. what() is one line.
class BadMission : public std::invalid_argument {
 public:
  BadMission(std::string key_path, const std::string& what)
      : std::invalid_argument(what), path(std::move(key_path)) {}

  std::string path;  ///< of the key in the mission file, such as `/leg/2/duration_s`
};

}  // namespace drydock::motion
