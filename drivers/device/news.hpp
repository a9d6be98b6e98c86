#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "drivers/device/life_cycle.hpp"

namespace drydock::device {

/// Decides which changes of state are reported. Between two periods of streaming each state is
/// reported once, and once more for each new kind of reason. Thus a device that is away for a day
/// is reported once, however often its link is tried. Different figures ("for 12 s", "retry in 1
/// s") do not make a new kind.
class News {
 public:
  /// Empty if it was reported already. Otherwise the change, from the state that was reported last.
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
  /// A port fails in fewer ways. More kinds than this are not reported.
  static constexpr std::size_t most_kinds = 16;

  /// FNV-1a over the state and the reason without its figures.
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
