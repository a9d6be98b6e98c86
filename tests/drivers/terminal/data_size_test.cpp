#include "drivers/terminal/data_size.hpp"

#include <gtest/gtest.h>

namespace data_size_test {

using drydock::terminal::data_size_text;
using drydock::terminal::no_data_size;
using drydock::terminal::parse_data_size;

// IEC 80000-13: MiB is 2^20 bytes; SI: MB is 10^6 bytes.
TEST(DataSize, HasAUnit) {
  EXPECT_EQ(parse_data_size("512MiB"), 536'870'912u);
  EXPECT_EQ(parse_data_size("20GB"), 20'000'000'000u);
  EXPECT_EQ(parse_data_size("1.5KiB"), 1536u);
  EXPECT_EQ(parse_data_size("2TiB"), 2'199'023'255'552u);
}

TEST(DataSize, IsRefusedWhereItCannotBeMeant) {
  for (const char* text : {"", "512", "MiB", "-1MiB", "0GB", "1e300TB", "nanMB", "1 MiB", "1mib"})
    EXPECT_EQ(parse_data_size(text), std::nullopt) << text;
  EXPECT_EQ(no_data_size("512"), "'512' is no size; allowed: 512MiB, 20GiB, 1.5TB");
}

// A unit below 1000 of which it has; no size but 0 is "0".
TEST(DataSize, IsSaidInTheUnitThatFits) {
  EXPECT_EQ(data_size_text(0), "0 B");
  EXPECT_EQ(data_size_text(999), "999 B");
  EXPECT_EQ(data_size_text(1'000), "1 kB");
  EXPECT_EQ(data_size_text(41'760), "42 kB");
  EXPECT_EQ(data_size_text(999'499), "999 kB");
  EXPECT_EQ(data_size_text(999'500), "1.0 MB");
  EXPECT_EQ(data_size_text(2'349'000), "2.3 MB");
  EXPECT_EQ(data_size_text(999'950'000), "1.0 GB");
  EXPECT_EQ(data_size_text(18'446'744'073'709'551'615u), "18446744073.7 GB");
}

}  // namespace data_size_test
