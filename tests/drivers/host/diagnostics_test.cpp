#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <set>

#include "drivers/host/rig_bus.hpp"

namespace drydock::host::diagnostics_test {
namespace {

/// The words between backticks in the first column of the table below "## Diagnostics".
std::set<std::string> keys_of_the_page() {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/build/bus.md");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.erase(0, text.find("## Diagnostics"));
  text.resize(text.find("\n## ", 1));
  std::set<std::string> keys;
  for (std::size_t row = text.find("\n| `"); row != std::string::npos;
       row = text.find("\n| `", row + 1)) {
    const std::string cell = text.substr(row + 3, text.find('|', row + 3) - row - 3);
    for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at + 1)) {
      const std::size_t end = cell.find('`', at + 1);
      keys.insert(cell.substr(at + 1, end - at - 1));
      at = end;
    }
  }
  return keys;
}

std::set<std::string> published_keys(const device::Device& device) {
  const auto status = status_of(device, device.health({}));
  std::set<std::string> keys;
  for (const auto& [key, value] : status.values) keys.insert(key);
  EXPECT_EQ(keys.size(), status.values.size()) << "a key is there twice";
  return keys;
}

device::DeviceOptions options_of(device::Kind kind, const std::string& protocol,
                                 const std::string& link) {
  device::DeviceOptions options;
  options.name = "sensor";
  options.link = link;
  options.driver.kind = kind;
  options.driver.protocol = protocol;
  return options;
}

TEST(Diagnostics, EveryPublishedKeyStandsOnThePageOfTheBusAndNoOther) {
  const auto page = keys_of_the_page();
  for (const auto& options :
       {options_of(device::Kind::dvl, "pd0", "pty:dvl"),
        options_of(device::Kind::depth, "cia404-pressure", "memory-can:bus")}) {
    const auto device = device::Device::make(options);
    ASSERT_TRUE(device) << options.driver.protocol;
    EXPECT_THAT(published_keys(**device), testing::ContainerEq(page)) << options.driver.protocol;
  }
}

}  // namespace
}  // namespace drydock::host::diagnostics_test
