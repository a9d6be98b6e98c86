#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Frames whose identifiers come only once. A node that joins repeats its identifiers; noise does
/// not. Those that come within ten seconds of each other are one bout.
class StrangeFrames {
 public:
  /// Strange frames that come at least so often, and at least so many of them, are no accident.
  static constexpr std::chrono::seconds pause{10};
  static constexpr unsigned fewest = 3;
  /// The next frame behind a strange one, if it comes so soon, is of the node that sent both.
  static constexpr std::chrono::milliseconds soon{3};

  /// An identifier that is not usual was among the last ones.
  bool is_repeated(std::uint32_t key) {
    if (std::ranges::find(recent_, key + 1) != recent_.end()) return true;
    recent_[next_recent_++ % recent_.size()] = key + 1;  // 0 stands for none
    return false;
  }
  /// True: a new bout begins.
  bool note(Stamp at) {
    const bool begins = at - latest_ > pause;
    if (begins) {
      count_ = 0;
      since_ = at;
    }
    ++count_;
    latest_ = at;
    behind_ = true;
    return begins;
  }
  /// A usual frame comes: whether it is right behind a strange one.
  bool come_before(Stamp at) {
    const bool behind = behind_ && at - latest_ < soon;
    behind_ = false;
    return behind;
  }
  /// There are enough of them, and more than were told.
  bool are_news() {
    if (count_ < fewest || count_ == told_) return false;
    told_ = count_;
    return true;
  }
  unsigned count() const { return count_; }
  Stamp since() const { return since_; }

 private:
  std::array<std::uint32_t, 64> recent_{};  ///< the last ones that are not usual, a ring
  std::size_t next_recent_ = 0;
  Stamp latest_{}, since_{};
  unsigned count_ = 0, told_ = 0;  ///< of the present bout
  bool behind_ = false;
};

}  // namespace drydock::diagnosis
