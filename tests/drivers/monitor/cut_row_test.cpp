#include "drivers/monitor/cut_row.hpp"

#include <gtest/gtest.h>

namespace cut_row_test {

using drydock::monitor::cut_row;

TEST(CutRow, KeepsAsManyColumnsAsTheTerminalHas) {
  EXPECT_EQ(cut_row("Ctrl-C ends with the report", 22), "Ctrl-C ends with the r");
  EXPECT_EQ(cut_row("short", 22), "short");
  EXPECT_EQ(cut_row("anything", 0), "");
}

TEST(CutRow, CountsACharacterOfSeveralBytesOnce) {
  EXPECT_EQ(cut_row("10 \u00b0C and more", 5), "10 \u00b0C");
}

TEST(CutRow, EndsEveryColourThatBegan) {
  EXPECT_EQ(cut_row("dvl \033[32mstreaming\033[0m 5.00 Hz", 8), "dvl \033[32mstre\033[0m");
  EXPECT_EQ(cut_row("\033[31mred\033[0m", 3), "\033[31mred\033[0m");
}

}  // namespace cut_row_test
