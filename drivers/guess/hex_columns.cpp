#include "drivers/guess/hex_columns.hpp"

namespace drydock::guess {
namespace {

constexpr std::size_t longest_column = 16;

/// How often each digit changed from text to text.
std::vector<std::size_t> changes_of(const std::vector<std::string_view>& texts) {
  std::vector<std::size_t> changes(texts.front().size());
  for (std::size_t i = 1; i < texts.size(); ++i)
    for (std::size_t at = 0; at < changes.size(); ++at)
      changes[at] += texts[i][at] != texts[i - 1][at];
  return changes;
}

}  // namespace

std::vector<std::size_t> hex_columns(const std::vector<std::string_view>& texts) {
  const auto changes = changes_of(texts);
  std::vector<std::size_t> columns{1};
  for (std::size_t at = 1; at < changes.size(); ++at) {
    const bool begins = 2 * changes[at] < changes[at - 1] || columns.back() == longest_column;
    if (begins)
      columns.push_back(1);
    else
      ++columns.back();
  }
  return columns;
}

}  // namespace drydock::guess
