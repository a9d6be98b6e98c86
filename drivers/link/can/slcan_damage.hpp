#pragma once

#include <cstdint>
#include <string>

namespace drydock::link {

/// Damaged lines of an slcan adapter since its channel was opened, in words. Lines are damaged
/// where the serial line loses bytes, or where the channel was found open amid one.
class SlcanDamage {
 public:
  /// `lines`: all damaged ones so far.
  void count(std::uint64_t lines, bool open) {
    if (!open) before_ = lines;
    if (lines == before_) return;
    note_ = std::to_string(lines - before_) +
            " damaged lines of the slcan adapter were left out: its serial line loses bytes (try "
            "flow control or a higher baud)";
  }
  const std::string& note() const { return note_; }  ///< empty: none

 private:
  std::uint64_t before_ = 0;
  std::string note_;
};

}  // namespace drydock::link
