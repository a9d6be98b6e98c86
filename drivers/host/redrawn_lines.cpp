#include "drivers/host/redrawn_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::host {

std::vector<std::string> in_lines(std::string first, const std::vector<std::string>& parts,
                                  std::size_t width) {
  std::vector<std::string> lines{std::move(first)};
  for (const auto& part : parts) {
    if (lines.back().size() + 2 + part.size() > width)
      lines.push_back("  " + part);
    else
      lines.back() += "  " + part;
  }
  for (auto& line : lines) line.resize(std::min(line.size(), width));
  return lines;
}

void RedrawnLines::draw(std::vector<std::string> lines) {
  lines.resize(std::min(lines.size(), terminal::screen_size(fileno(out_)).rows));
  wipe();
  for (std::size_t i = 0; i < lines.size(); ++i)
    fmt::print(out_, "{}{}", i == 0 ? "" : "\n", lines[i]);
  std::fflush(out_);
  drawn_ = lines.size();
}

void RedrawnLines::wipe() {
  if (drawn_ == 0) return;
  fmt::print(out_, "{}", terminal::wipe_line);
  for (; drawn_ > 1; --drawn_) fmt::print(out_, "{}", terminal::wipe_line_above);
  drawn_ = 0;
  std::fflush(out_);
}

}  // namespace drydock::host
