#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace drydock::score {

/// Counts what a reader passes over, by sort, and keeps the first place of each.
class PassedOver {
 public:
  /// `what` is counted: "line".
  explicit PassedOver(std::string what) : what_(std::move(what)) {}

  void add(const std::string& why, std::uint64_t number);
  /// "more cells than names, left out: 3 lines, the first is line 7"
  std::vector<std::string> notes() const;

 private:
  struct Sort {
    std::string why;
    std::uint64_t times = 0, first = 0;
  };
  std::string what_;
  std::vector<Sort> sorts_;
};

}  // namespace drydock::score
