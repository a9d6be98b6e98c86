#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace drydock::rig_config {

/// Where the values of a file stand, for checks that need more than the file.
struct Places {
  std::string file;
  /// Line and column, from 1, of each value. The key is its path, such as `/device/0/rate_hz`.
  std::map<std::string, std::pair<int, int>> at;
};

using PlacesPtr = std::shared_ptr<const Places>;

}  // namespace drydock::rig_config
