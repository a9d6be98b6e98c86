#include "tests/drivers/mcap/read_back.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace drydock::mcap::test {

std::optional<nlohmann::json> read_back(const std::filesystem::path& file) {
  const std::filesystem::path source = DRYDOCK_SOURCE_DIR;
  const auto packages = source / "build/npm/node_modules";
  if (!std::filesystem::exists(packages / "@mcap/core")) return {};
  const std::string command = "NODE_PATH=" + packages.string() + " node " +
                              (source / "tests/drivers/mcap/read_back.cjs").string() + " " +
                              file.string();
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
    text.append(chunk.data(), n);
  if (pclose(pipe) != 0) return {};
  return nlohmann::json::parse(text);
}

}  // namespace drydock::mcap::test
