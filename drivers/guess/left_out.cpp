#include "drivers/guess/left_out.hpp"

#include <fmt/format.h>

namespace drydock::guess {

std::string in_comment(std::string_view line) {
  std::string text(line);
  for (char& c : text)
    if (c < 0x20 || c > 0x7E) c = '.';
  return text;
}

void LeftOut::add(std::string_view line, std::size_t times) {
  constexpr std::size_t shown = 60;
  const std::string text = in_comment(line.substr(0, shown));
  Kind& kind = kinds_[text.substr(0, text.find_first_of(" ,"))];
  if (kind.times == 0) kind.example = text;
  kind.times += times;
}

std::string LeftOut::text() const {
  constexpr std::size_t most_kinds = 16;
  std::string out;
  std::size_t kinds = 0, others = 0;
  for (const auto& [word, kind] : kinds_) {
    if (kinds++ < most_kinds)
      out += fmt::format("# {} times: {}\n", kind.times, kind.example);
    else
      others += kind.times;
  }
  if (others > 0) out += fmt::format("# and {} other lines\n", others);
  return out.empty() ? out : "\n# Not described:\n" + out;
}

}  // namespace drydock::guess
