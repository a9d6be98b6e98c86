#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

/// Other people's programs in JavaScript as witnesses: a script of the tests run by node with the
/// packages of tests/npm, and the JSON that it prints.
namespace drydock::test {

/// Node and the packages are there.
bool have_node();

/// What a command of the shell prints, as JSON. `input`, where given, becomes its standard input.
/// A command that failed gives {"failed": what it printed}.
nlohmann::json run_for_json(std::string command, const std::optional<std::string>& input = {});

/// The program and its arguments that run a script (a path from the root of the tree).
std::vector<std::string> node_command(const std::string& script,
                                      const std::vector<std::string>& arguments);

/// `script` is a path from the root of the tree. `input`, where given, becomes its standard input.
/// A script that failed gives {"failed": what it printed}.
nlohmann::json run_node(const std::string& script, const std::vector<std::string>& arguments,
                        const std::optional<std::string>& input = {});

}  // namespace drydock::test

/// At the start of a TEST or SetUp: without node a skip in one line, in CI a failure.
#define DRYDOCK_NEEDS_NODE()                                                                  \
  if (!drydock::test::have_node()) {                                                          \
    ASSERT_EQ(std::getenv("CI"), nullptr) << "node or the packages of tests/npm are missing"; \
    GTEST_SKIP() << "node or build/npm absent: ./rig test brings them";                       \
  }                                                                                           \
  static_assert(true)
