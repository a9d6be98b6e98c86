#pragma once

#include <cstddef>
#include <string>

namespace drydock::rig_config {

struct Node;

/// A block `[[estimator]]` of a rig file and its index among them.
struct EstimatorBlock {
  const Node& table;
  std::size_t index;
  const std::string& file;  ///< path of the rig file
};

}  // namespace drydock::rig_config
