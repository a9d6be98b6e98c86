#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drivers/wire/described/described_codec.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// The shipped descriptions, and those of a test's text.
namespace drydock::described::test {

using rig_config::DescriptionPtr;

inline DescriptionPtr shipped(const std::string& name) {
  auto found = rig_config::find_description(name, "no-such-folder/");
  EXPECT_TRUE(found) << (found ? "" : to_string(found.error().front()));
  return *found;
}

inline DescriptionPtr described(std::string_view text) {
  auto loaded = rig_config::load_description_text(text, "folder/toy.toml");
  EXPECT_TRUE(loaded) << (loaded ? "" : to_string(loaded.error().front()));
  return *loaded;
}

/// The problems of a description, one line each.
inline std::string problems_of(std::string_view text) {
  const auto loaded = rig_config::load_description_text(text, "toy.toml");
  std::string lines;
  if (!loaded)
    for (const auto& problem : loaded.error()) lines += to_string(problem) + "\n";
  return lines;
}

/// The value of a key of a record; NaN if it has none.
inline double value_of(const wire::described::Record& record, std::string_view wanted) {
  double found = std::nan("");
  bool known = false;
  visit_fields(record, [&](std::string_view key, const auto& value) {
    if (key != wanted) return;
    known = true;
    if constexpr (requires { value.has_value(); })
      if (value) found = *value;
  });
  EXPECT_TRUE(known) << "no key " << wanted;
  return found;
}

}  // namespace drydock::described::test
