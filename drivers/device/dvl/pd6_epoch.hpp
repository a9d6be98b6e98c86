#pragma once

#include <chrono>
#include <cstdint>

#include "drivers/device/epoch_begin.hpp"
#include "drivers/device/timing.hpp"
#include "drivers/wire/dvl/pd6.hpp"

namespace drydock::device {

/// Joins the lines of one PD6 ensemble. The lines have neither number nor checksum, so an ensemble
/// must meet all these conditions. It begins with :SA (or with :TS, if no :SA comes). The lines are
/// in the document's order. :TS and all four lines of bottom track are there. No line since the
/// begin was damaged. The lines took no longer than their bytes need on the wire plus 0.1 s. :BD
/// completes it.
class Pd6Epoch {
 public:
  enum class Step : std::uint8_t { idle, under_way, complete, broken };

  struct Lines {
    wire::Pd6Attitude attitude;
    wire::Pd6Timing timing;
    wire::Pd6BottomInstrument instrument;
    wire::Pd6BottomEarth earth;
    wire::Pd6BottomDistance distance;
  };

  /// How a line came: `on_wire` is its duration, `skipped` that of the bytes in front of it that
  /// were no line, `damaged` counts the damaged lines so far.
  struct Came {
    Origin origin;
    std::chrono::nanoseconds on_wire, skipped;
    std::uint64_t damaged = 0;
  };

  /// The result `broken` means that this line ended an incomplete epoch; the line may have begun
  /// the next.
  Step take(const wire::Pd6::Message& line, const Came& came);

  const Lines& lines() const { return lines_; }  ///< of the last complete epoch
  /// valid_at of the first line (EpochBegin), received_at of the last
  const Origin& origin() const { return origin_; }
  void restart() {
    under_way_ = false;
    begin_.forget();
  }

 private:
  bool continues(std::size_t rank, std::uint64_t damaged) const;
  void begin(const Came& came);

  Lines lines_;
  Origin origin_;
  EpochBegin begin_;
  std::chrono::nanoseconds skipped_{};  ///< in front of the first line
  Stamp began_{};
  std::chrono::nanoseconds on_wire_{0};  ///< sum for the lines so far, without the first
  std::uint64_t damaged_ = 0;            ///< count when the epoch began
  unsigned seen_ = 0;                    ///< one bit for each kind of line
  std::size_t last_ = 0;
  bool under_way_ = false;
};

}  // namespace drydock::device
