#pragma once

#include "drivers/guess/guess.hpp"
#include "tests/drivers/described/support.hpp"

/// What a first description of made-up lines says and reads.
namespace drydock::described::test {

inline std::string lines_of(int count, auto&& line) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line(i) + "\r\n";
  return text;
}

/// The guess with a column that is measured, and so with the kind of sensor that measures it.
inline std::string measured(std::string guess, const std::string& column,
                            const std::string& field) {
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{column, field}, {"# kind = ", "kind = "}}) {
    const auto at = guess.find(from);
    EXPECT_NE(at, guess.npos) << guess;
    if (at != guess.npos) guess.replace(at, from.size(), to);
  }
  return guess;
}

/// What a description reads from one line. NaN: nothing.
inline double read(const std::string& guess, const std::string& line, const std::string& key) {
  const auto description = described(guess);
  wire::described::Record record;
  const auto decoded =
      wire::described::decode(description->plan, wire::testing::as_bytes(line + "\r\n"), record);
  EXPECT_EQ(decoded, wire::described::Decoded::message) << guess;
  return decoded == wire::described::Decoded::message ? value_of(record, key) : std::nan("");
}

}  // namespace drydock::described::test
