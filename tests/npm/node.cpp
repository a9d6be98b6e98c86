#include "tests/npm/node.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace drydock::test {

namespace {
const std::string packages = DRYDOCK_SOURCE_DIR "/build/npm/node_modules";
}  // namespace

bool have_node() {
  return std::filesystem::exists(packages + "/@mcap/core") &&
         std::system("command -v node >/dev/null") == 0;
}

nlohmann::json run_for_json(std::string command, const std::optional<std::string>& input) {
  const auto file =
      std::filesystem::temp_directory_path() / ("drydock-input-" + std::to_string(::getpid()));
  if (input) {
    std::ofstream(file) << *input;
    command += " < " + file.string();
  }
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
    text.append(chunk.data(), n);
  const bool good = pclose(pipe) == 0;
  std::filesystem::remove(file);
  auto said = nlohmann::json::parse(text, nullptr, false);
  if (good || (said.is_object() && said.contains("failed"))) return said;
  return {{"failed", text}};  // a test's message shows it
}

std::vector<std::string> node_command(const std::string& script,
                                      const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"env", "NODE_PATH=" + packages, "node",
                                   DRYDOCK_SOURCE_DIR "/" + script};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

nlohmann::json run_node(const std::string& script, const std::vector<std::string>& arguments,
                        const std::optional<std::string>& input) {
  std::string command = "NODE_PATH=" + packages + " node " DRYDOCK_SOURCE_DIR "/" + script;
  for (const auto& argument : arguments) command += " '" + argument + "'";
  return run_for_json(std::move(command), input);
}

}  // namespace drydock::test
