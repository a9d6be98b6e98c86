#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "drivers/device/life_cycle.hpp"

namespace drydock::device {

/// Which changes of state are told. From one time of streaming to the next each state is told once,
/// and once more for each new kind of reason: a device that is away for a day says it once, however
/// often its link is tried. Figures ("for 12 s", "retry in 1 s") make no new kind.
class News {
 public:
  /// Empty: said already. Else the change, from the state that was told last.
  LifeCycle::Change tell(LifeCycle::Change change) {
    if (!change) return {};
    if (change->to == State::streaming || change->to == State::closed) {
      count_ = 0;
    } else if (!is_new(kind_of(*change))) {
      return {};
    }
    change->from = told_;
    told_ = change->to;
    return change;
  }

 private:
  /// More kinds than a port has ways to fail; what comes on top is not told.
  static constexpr std::size_t most_kinds = 16;

  /// FNV-1a over state and reason without its figures.
  static std::uint64_t kind_of(const Transition& change) {
    std::uint64_t hash = 0xCBF29CE484222325;
    const auto add = [&](unsigned char byte) { hash = (hash ^ byte) * 0x100000001B3; };
    add(static_cast<unsigned char>(change.to));
    for (const char c : change.why.view())
      if ((c < '0' || c > '9') && c != '.') add(static_cast<unsigned char>(c));
    return hash;
  }

  bool is_new(std::uint64_t kind) {
    const auto end = said_.begin() + count_;
    if (count_ == most_kinds || std::find(said_.begin(), end, kind) != end) return false;
    said_[count_++] = kind;
    return true;
  }

  std::array<std::uint64_t, most_kinds> said_{};
  std::size_t count_ = 0;
  State told_ = State::closed;
};

}  // namespace drydock::device
