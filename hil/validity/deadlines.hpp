#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "hil/validity/figures.hpp"

/// Whether periodic samples were out of their drivers in time. docs/sensors/time-of-validity.md
namespace drydock::validity {

/// How late the machine made a bare timer and a bare link in each second of a run.
class Floor {
 public:
  /// Readings in microseconds, each with when it was seen; it counts for every second it lasted.
  void add_timer(Stamp seen, double late_us) { add(seen, late_us, &Worst::timer_us); }
  void add_link(Stamp seen, double took_us) { add(seen, took_us, &Worst::link_us); }

  /// The worst timer and the worst link of a second between the two; zero where nothing was read.
  double worst_us(Stamp from, Stamp to) const;

 private:
  struct Worst {
    double timer_us = 0, link_us = 0;
  };
  void add(Stamp seen, double us, double Worst::*which);

  std::map<std::int64_t, Worst> seconds_;
};

/// A sample's response is from when it was taken until the last of what it says is out of its
/// driver. Its deadline is one period (Liu and Layland 1973: before the next of its kind), and what
/// the floor had in the same seconds. What is due after the run's end is not judged.
struct Deadlines {
  std::string device;
  double asked_hz = 0, sent_hz = 0;  ///< by the rig; by what left, from the first to come out on
  double judged_s = 0;               ///< from the first sample to come out until the run's end
  double first_s = 0;                ///< from the run's begin until the first was out
  std::size_t samples = 0;           ///< judged: missed and lost ones too
  std::size_t lost = 0;              ///< nothing came of them
  std::size_t stalled = 0;           ///< nor of these, but the floor alone was a period late there
  std::size_t missed = 0;            ///< came too late
  Spread response;
  double least_margin_us = 0;  ///< of deadline less response; below zero: by how much it was missed

  bool rate_held() const;  ///< to one sample
  bool kept() const { return samples > 0 && lost == 0 && missed == 0 && rate_held(); }
};

struct Period {
  Stamp begin, end;
};

/// `sent`: when the device's samples were taken, in order; `figures`: of this device.
Deadlines deadlines_of(std::string device, double rate_hz, std::span<const Stamp> sent,
                       std::span<const Figures> figures, const Floor& floor, Period run);

}  // namespace drydock::validity
