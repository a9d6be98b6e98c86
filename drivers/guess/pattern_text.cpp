#include "drivers/guess/pattern_text.hpp"

#include <fmt/format.h>

#include "drivers/guess/line_cut.hpp"

namespace drydock::guess {

std::string regex_of(std::string_view text) {
  constexpr std::string_view foreign = "[^ -~]*";
  std::string out;
  for (const char c : text) {
    if (is_foreign(c))
      out += out.ends_with(foreign) ? std::string_view() : foreign;
    else if (c == '\'' || c == '\t')
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
    else if (is_letter(c) || is_digit(c) ||
             std::string_view(" ,;:=#%&/<>@_~\"!").find(c) != std::string_view::npos)
      out += c;
    else
      out += {'\\', c};
  }
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (is_foreign(c)) continue;
    if (c == '\t') {
      out += "\\t";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string with_double_brackets(std::string_view text) {
  std::string out;
  for (const char c : text) out.append(c == '{' ? 2 : 1, c);
  return out;
}

}  // namespace drydock::guess
