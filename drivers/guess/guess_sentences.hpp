#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// A checksum behind the '*' that is right in nearly all lines, and the first byte that it covers.
struct LineSum {
  std::string_view checksum = "none";
  std::size_t from = 0;
};

/// The sentences of a capture with their columns, as a description. Lines that a description cannot
/// hold are named in a comment. Empty: all of them are such.
std::string guess_sentences(const std::vector<std::string_view>& lines, const LineSum& sum);

}  // namespace drydock::guess
