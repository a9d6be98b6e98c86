#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

/// The fields of a line of a RINEX file, which Fortran wrote.
namespace drydock::sky {

/// `width` columns from column `from` (from 0), as far as the line has them.
inline std::string_view columns(std::string_view line, std::size_t from, std::size_t width) {
  return from < line.size() ? line.substr(from, width) : std::string_view{};
}

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// Empty: not a whole number and nothing else.
template <class Integer>
std::optional<Integer> integer(std::string_view text) {
  Integer value{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && rest == end ? std::optional{value} : std::nullopt;
}

/// Fortran's D19.12: the exponent's letter may be D, and one of three digits has none. Empty: no
/// finite number.
std::optional<double> real(std::string_view text);

}  // namespace drydock::sky
