#pragma once

#include <optional>

#include "drivers/diagnosis/monitors/clock_watch.hpp"
#include "drivers/diagnosis/monitors/raster.hpp"
#include "drivers/diagnosis/monitors/rate_watch.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// What the own time of one kind of message says beside its arrival: times that go back, a delay, a
/// clock that was set, the clock's rate.
class StreamClock {
 public:
  struct News {
    bool backwards = false, repeated = false;
    std::optional<Sign> sign = {};  ///< late or clock_step
    Stamp since{};
    Amount amount{};
  };

  /// True if the message comes otherwise after its own time than the one before. Once a message,
  /// before add(); without an own time nobody knows.
  bool moves(const measurement::Origin& origin);
  /// `step`: how it came against its raster. `shift_s`: by so much the line may have moved it.
  /// `moved`: and it has. `has_clock`: its times are of a clock that can drift.
  News add(const measurement::Origin& origin, Step step, double shift_s, bool moved,
           bool has_clock);

  bool known() const { return watch_.known(); }
  const RateWatch& rate() const { return rate_; }

 private:
  News judge(const ClockWatch::News& news, Stamp at, Step step, double shift_s);

  ClockWatch watch_;
  RateWatch rate_;
  std::optional<std::chrono::nanoseconds> late_;  ///< arrival less the own time, of the latest one
  int jumps_ = 0;                                 ///< messages in a row whose clock is off
  Stamp jump_since_{};
  bool late_by_clock_ = false;
};

}  // namespace drydock::diagnosis
