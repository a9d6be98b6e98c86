#pragma once

#include "tests/npm/node.hpp"

namespace drydock::mcap::test {

/// The content of a file according to the MCAP project's own reader and Foxglove's decoder of ROS 2
/// messages.
inline nlohmann::json read_back(const std::string& file) {
  return drydock::test::run_node("tests/drivers/recordings/mcap/read_back.cjs", {file});
}

}  // namespace drydock::mcap::test
