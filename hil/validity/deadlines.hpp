#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "hil/validity/figures.hpp"

/// Checks whether periodic samples came out of their drivers in time.
/// docs/sensors/time-of-validity.md
namespace drydock::validity {

/// Delays of a bare timer and a bare link on this machine, for each second of a run.
class Floor {
 public:
  /// Readings in microseconds with the time at their end. A reading counts for every second that it
  /// covers.
  void add_timer(Stamp seen, double late_us) { add(seen, late_us, &Worst::timer_us); }
  void add_link(Stamp seen, double took_us) { add(seen, took_us, &Worst::link_us); }

  /// The worst sum of timer and link delay of one second between the two times; zero without
  /// readings.
  double worst_us(Stamp from, Stamp to) const;

 private:
  struct Worst {
    double timer_us = 0, link_us = 0;
  };
  void add(Stamp seen, double us, double Worst::*which);

  std::map<std::int64_t, Worst> seconds_;
};

/// The response of a sample is the time from the sample until the last measurement from it is out
/// of its driver. Its deadline is one period (Liu and Layland 1973: before the next sample) plus
/// the floor's delay in the same seconds. A lost sample whose deadline is after the run's end is
/// not judged.
struct Deadlines {
  std::string device;
  double asked_hz = 0, sent_hz = 0;  ///< required by the rig; measured from the first sample that
                                     ///< came out
  double judged_s = 0;               ///< from the first sample that came out until the run's end
  double first_s = 0;                ///< from the run's start until the first sample was out
  std::size_t samples = 0;           ///< judged samples, including missed and lost ones
  std::size_t lost = 0;              ///< no measurement came from them
  std::size_t stalled = 0;           ///< the same, but the floor alone was a period late there
  std::size_t missed = 0;            ///< too late
  Spread response;
  double least_margin_us = 0;  ///< smallest deadline minus response; negative: missed by so much

  bool rate_held() const;  ///< within one sample
  bool kept() const { return samples > 0 && lost == 0 && missed == 0 && rate_held(); }
};

struct Period {
  Stamp begin, end;
};

/// `sent`: times of the device's samples, in order. `figures`: of this device.
Deadlines deadlines_of(std::string device, double rate_hz, std::span<const Stamp> sent,
                       std::span<const Figures> figures, const Floor& floor, Period run);

}  // namespace drydock::validity
