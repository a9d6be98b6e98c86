#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace drydock::host {

/// `first`, then the parts, two spaces apart; what does not fit into `width` columns goes on on a
/// further line. No part is divided, but one wider than a line is cut.
std::vector<std::string> in_lines(std::string first, const std::vector<std::string>& parts,
                                  std::size_t width);

/// The last lines of a terminal that can erase them, drawn over themselves.
class RedrawnLines {
 public:
  explicit RedrawnLines(std::FILE* out) : out_(out) {}

  void draw(std::vector<std::string> lines);  ///< no more than the terminal has rows
  void wipe();

 private:
  std::FILE* out_;
  std::size_t drawn_ = 0;  ///< lines
};

}  // namespace drydock::host
