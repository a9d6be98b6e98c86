#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "drivers/wire/dbc/reader.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::dbc::test {

inline std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of the corpus by the stem of its expected values.
inline std::string corpus_file(const std::string& stem) {
  const auto path = wire::test::corpus("dbc/files/" + stem + ".dbc");
  return std::filesystem::exists(path) ? path : wire::test::corpus("can_imu/" + stem + ".dbc");
}

inline std::string all(const std::vector<Remark>& remarks) {
  std::string text;
  for (const Remark& r : remarks)
    text += std::to_string(r.at.line) + ":" + std::to_string(r.at.column) + ": " + r.text + "\n";
  return text;
}

/// A database that has to be without errors.
inline Database sound(const std::string& text) {
  Reading reading = read(text);
  EXPECT_EQ(all(reading.errors), "");
  return std::move(reading.database);
}

}  // namespace drydock::wire::dbc::test
