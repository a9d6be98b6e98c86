#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "drivers/diagnosis/cause.hpp"
#include "drivers/diagnosis/sign.hpp"

namespace drydock::diagnosis::findings_page_test {

std::string page() {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/pier/findings.md");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(FindingsPage, HasARowForEachCauseWithItsMeaningAndAdvice) {
  const std::string text = page();
  for (const CauseFacts& facts : causes()) {
    const auto row = fmt::format("| `{}` | {} | {} |", facts.name, facts.meaning, facts.advice);
    EXPECT_NE(text.find(row), std::string::npos) << row;
  }
}

TEST(FindingsPage, NamesEachSign) {
  const std::string text = page();
  for (unsigned i = 0; i < diagnosis::sign_count; ++i) {
    const auto name = to_string(static_cast<Sign>(i));
    EXPECT_NE(text.find(fmt::format("| {} |", name)), std::string::npos) << name;
  }
}

}  // namespace drydock::diagnosis::findings_page_test
