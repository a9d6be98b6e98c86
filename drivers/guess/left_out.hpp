#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace drydock::guess {

/// A line as a comment of a description shows it, which is UTF-8 in one line.
std::string in_comment(std::string_view line);

/// Lines of a capture that are no message of the description: one example for each beginning.
class LeftOut {
 public:
  void add(std::string_view line, std::size_t times = 1);

  /// A comment of the description; empty: none was left out.
  std::string text() const;

 private:
  struct Kind {
    std::size_t times = 0;
    std::string example;
  };
  std::map<std::string, Kind, std::less<>> kinds_;  ///< by the first word
};

}  // namespace drydock::guess
