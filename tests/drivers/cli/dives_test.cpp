#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include "drivers/cli/fixture.hpp"
#include "tests/drivers/cli/captured.hpp"
#include "tests/drivers/record/sample_dive.hpp"

/// Every dive under fixtures/dives, made by `drydock cut --as-fixture`, goes through the drivers
/// again.
namespace drydock::cli {
namespace dives_test {

std::vector<std::string> dives() {
  std::vector<std::string> names;
  const std::filesystem::path all = DRYDOCK_SOURCE_DIR "/fixtures/dives";
  for (const auto& entry : std::filesystem::directory_iterator(all))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Dive : public testing::TestWithParam<std::string> {};

TEST_P(Dive, GivesTheMeasurementsThatItGaveWhenItWasKept) {
  const auto folder = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures/dives" / GetParam();
  MemoryFile now;
  const auto played = write_measurements((folder / fixture_recording).string(), {}, now.file());
  ASSERT_TRUE(played) << played.error().line;
  EXPECT_GT(*played, 0U);
  EXPECT_EQ(now.text(), record::test::read_all((folder / fixture_reference).string()));
}

INSTANTIATE_TEST_SUITE_P(Fixtures, Dive, testing::ValuesIn(dives()), [](const auto& dive) {
  std::string name = dive.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

}  // namespace dives_test
}  // namespace drydock::cli
