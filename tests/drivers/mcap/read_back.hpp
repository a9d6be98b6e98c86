#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

/// What the MCAP project's own reader and Foxglove's decoder of ROS 2 messages find in a file.
namespace drydock::mcap::test {

/// Empty where node or its packages are not there: outside CI that is a reason to skip.
std::optional<nlohmann::json> read_back(const std::filesystem::path& file);

}  // namespace drydock::mcap::test

/// In a TEST: the JSON of read_back.cjs, or a skip in one line (a failure in CI).
#define DRYDOCK_READ_BACK(found, file)                                            \
  const auto found##_or_none = drydock::mcap::test::read_back(file);              \
  if (!found##_or_none) {                                                         \
    ASSERT_EQ(std::getenv("CI"), nullptr) << "node and its packages are missing"; \
    GTEST_SKIP() << "node or build/npm absent: ./rig test brings them";           \
  }                                                                               \
  nlohmann::json found = *found##_or_none
