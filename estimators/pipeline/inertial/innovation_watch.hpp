#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "drivers/measurement/stamp.hpp"
#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_window.hpp"

namespace drydock::pipeline {

/// The sensors whose innovations an inertial navigation has; `model`: the velocity of a model of
/// the vehicle that aids it.
enum class Aid : std::uint8_t { log, ground, position, heading, depth, model };

/// Judges the innovations of all aiding sensors, each row by itself.
class InnovationWatch {
 public:
  using Stamp = measurement::Stamp;

  void add(Aid aid, const navigation::Innovations& rows, Stamp now) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      windows_[static_cast<std::size_t>(aid)][row].add(rows[row].value / rows[row].sigma);
    if (rows.empty()) return;
    heard_[static_cast<std::size_t>(aid)] = now;
    off_[static_cast<std::size_t>(aid)] =
        std::hypot(rows[0].value, rows.size() > 1 ? rows[1].value : 0);
  }
  void clear() { *this = {}; }

  /// The number of sensors whose innovations contradict the filter.
  std::ptrdiff_t contradictions() const { return std::ranges::count_if(windows_, any_row); }
  bool contradicts(Aid aid) const { return any_row(windows_[static_cast<std::size_t>(aid)]); }
  /// Likewise, by a value that is not older than this.
  bool contradicts(Aid aid, Stamp now, std::chrono::nanoseconds within) const {
    return contradicts(aid) && now - heard_[static_cast<std::size_t>(aid)] <= within;
  }
  /// How far the last value was from the expected one, by its first two rows; 0: there was none.
  double off(Aid aid) const { return off_[static_cast<std::size_t>(aid)]; }

 private:
  using Rows = std::array<navigation::InnovationWindow, 3>;
  static bool any_row(const Rows& rows) {
    return std::ranges::any_of(rows, &navigation::InnovationWindow::contradicts);
  }

  std::array<Rows, 6> windows_;
  std::array<double, 6> off_{};
  std::array<Stamp, 6> heard_{};
};

}  // namespace drydock::pipeline
