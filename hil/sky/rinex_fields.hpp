#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

/// The fields of a line of a RINEX file, in Fortran formats.
namespace drydock::sky {

/// `width` columns from column `from` (counted from 0), or fewer if the line is shorter.
inline std::string_view columns(std::string_view line, std::size_t from, std::size_t width) {
  return from < line.size() ? line.substr(from, width) : std::string_view{};
}

/// Removes blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// Empty if the text is not exactly one whole number.
template <class Integer>
std::optional<Integer> integer(std::string_view text) {
  Integer value{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && rest == end ? std::optional{value} : std::nullopt;
}

/// Fortran's D19.12: the exponent letter may be D, and an exponent of three digits has no letter.
/// Empty if the text is no finite number.
std::optional<double> real(std::string_view text);

}  // namespace drydock::sky
