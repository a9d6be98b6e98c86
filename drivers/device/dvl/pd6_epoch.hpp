#pragma once

#include <chrono>
#include <cstdint>

#include "drivers/device/timing.hpp"
#include "drivers/wire/dvl/pd6.hpp"

namespace drydock::device {

/// Puts the lines of one PD6 ensemble together. They carry neither number nor checksum, so an epoch
/// counts only when it came in one piece: begun by :SA (or :TS, where no :SA comes), each line
/// behind the one before as the document orders them, :TS and all four of bottom track there, no
/// damaged line since its begin, and no longer on the way than its bytes take and 0.1 s. :BD
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

  /// A line that came as `origin` says, `on_wire` long; `damaged` counts the damaged ones so far.
  /// `broken`: the epoch before the line was lost by it; the line may have begun the next.
  Step take(const wire::Pd6::Message& line, const Origin& origin, std::chrono::nanoseconds on_wire,
            std::uint64_t damaged);

  const Lines& lines() const { return lines_; }  ///< of the epoch just completed
  const Origin& origin() const {
    return origin_;
  }  ///< valid as its first line, received as its last
  void forget() { under_way_ = false; }

 private:
  bool continues(std::size_t rank, std::uint64_t damaged) const;
  void begin(const Origin& origin, std::uint64_t damaged);

  Lines lines_;
  Origin origin_;
  Stamp began_{};
  std::chrono::nanoseconds on_wire_{0};  ///< of the lines so far, but for the first
  std::uint64_t damaged_ = 0;            ///< when it began
  unsigned seen_ = 0;                    ///< a bit for each kind of line
  std::size_t last_ = 0;
  bool under_way_ = false;
};

}  // namespace drydock::device
