#include "tests/ports/driver.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace drydock::ports {

std::string kernel_driver(const std::string& port) {
  namespace fs = std::filesystem;
  const bool is_can = port.starts_with("can");
  std::error_code failure;
  const auto name = is_can ? port : fs::canonical(port, failure).filename().string();
  const auto driver = fs::canonical(
      (is_can ? "/sys/class/net/" : "/sys/class/tty/") + name + "/device/driver", failure);
  if (failure) return {};
  return driver.parent_path().parent_path().filename() / driver.filename();
}

void runs_on(const std::vector<std::string>& ports, const std::string& more) {
  std::set<std::string> drivers{more};
  for (const auto& port : ports) drivers.insert(kernel_driver(port));
  std::string names;
  for (const auto& name : drivers) names += (names.empty() ? "" : " ") + name;
  ::testing::Test::RecordProperty("kernel_drivers", names);
}

}  // namespace drydock::ports
