#include "rig_config/toml/syntax_advice.hpp"

#include <algorithm>

namespace drydock::rig_config {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// In an array such a comma parts two values.
bool has_decimal_comma(std::string_view line) {
  if (line.find('[') != std::string_view::npos) return false;
  for (auto at = line.find(','); at != std::string_view::npos; at = line.find(',', at + 1))
    if (at > 0 && at + 1 < line.size() && is_digit(line[at - 1]) && is_digit(line[at + 1]))
      return true;
  return false;
}

/// An odd number of quotes: one of them has no partner.
bool has_open_quote(std::string_view line) { return std::ranges::count(line, '"') % 2 == 1; }

}  // namespace

std::string syntax_advice(std::string_view what, std::string_view line) {
  const auto says = [&](std::string_view words) {
    return what.find(words) != std::string_view::npos;
  };
  if (says("invalid utf-8")) return "; save the file as UTF-8";
  if ((says("saw ','") || says("saw '}'")) && has_decimal_comma(line))
    return "; a number has a point, not a comma";
  if (says("parsing string") && has_open_quote(line)) return "; a closing quote is missing";
  if (says("could not determine value type")) return "; a text stands in \"quotes\"";
  if (says("cannot redefine existing table"))
    return "; a list of tables has two brackets, such as [[device]]";
  if (says("cannot redefine existing")) return "; keep one of the two";
  if (says("saw ':'")) return "; a value is written key = value";
  if (says("parsing root table") && says("saw '{'"))
    return "; this looks like JSON, expected is TOML: key = value";
  return "";
}

}  // namespace drydock::rig_config
