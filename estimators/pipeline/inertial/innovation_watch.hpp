#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_window.hpp"

namespace drydock::pipeline {

/// The sensors whose innovations an inertial navigation has.
enum class Aid : std::uint8_t { log, ground, position, heading, depth };

/// Judges the innovations of all aiding sensors, each row by itself.
class InnovationWatch {
 public:
  void add(Aid aid, const navigation::Innovations& rows) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      windows_[static_cast<std::size_t>(aid)][row].add(rows[row].value / rows[row].sigma);
    if (aid == Aid::position && rows.size() >= 2)
      position_off_m_ = std::hypot(rows[0].value, rows[1].value);
  }
  void clear() { *this = {}; }

  /// The number of sensors whose innovations contradict the filter.
  std::ptrdiff_t contradictions() const {
    return std::ranges::count_if(windows_, [](const auto& rows) {
      return std::ranges::any_of(rows, &navigation::InnovationWindow::contradicts);
    });
  }
  /// Horizontal distance of the last position that a sensor gave from the expected one; 0: none.
  double position_off_m() const { return position_off_m_; }

 private:
  std::array<std::array<navigation::InnovationWindow, 3>, 5> windows_;
  double position_off_m_ = 0;
};

}  // namespace drydock::pipeline
