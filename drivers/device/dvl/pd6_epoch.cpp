#include "drivers/device/dvl/pd6_epoch.hpp"

namespace drydock::device {

namespace {

constexpr std::chrono::milliseconds longest_pause{100};

/// Indices in Pd6::Message. They are in the order of the lines in an ensemble.
constexpr std::size_t attitude = 0, timing = 1, bottom_instrument = 6, bottom_ship = 7,
                      bottom_earth = 8, bottom_distance = 9;
constexpr unsigned needed = 1u << timing | 1u << bottom_instrument | 1u << bottom_ship |
                            1u << bottom_earth | 1u << bottom_distance;

struct Keep {
  Pd6Epoch::Lines& lines;
  void operator()(const wire::Pd6Attitude& line) const { lines.attitude = line; }
  void operator()(const wire::Pd6Timing& line) const { lines.timing = line; }
  void operator()(const wire::Pd6BottomInstrument& line) const { lines.instrument = line; }
  void operator()(const wire::Pd6BottomEarth& line) const { lines.earth = line; }
  void operator()(const wire::Pd6BottomDistance& line) const { lines.distance = line; }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

bool Pd6Epoch::continues(std::size_t rank, std::uint64_t damaged) const {
  return rank > last_ && damaged == damaged_ &&
         origin_.received_at - began_ <= on_wire_ + longest_pause;
}

void Pd6Epoch::begin(const Came& came) {
  lines_ = {};
  origin_ = came.origin;
  skipped_ = came.skipped;
  began_ = came.origin.received_at;
  on_wire_ = {};
  damaged_ = came.damaged;
  seen_ = 0;
  under_way_ = true;
}

Pd6Epoch::Step Pd6Epoch::take(const wire::Pd6::Message& line, const Came& came) {
  const std::size_t rank = line.index();
  const bool begins = rank == attitude || (rank == timing && !(under_way_ && last_ == attitude));
  if (!begins && !under_way_) return Step::idle;

  Step step = Step::under_way;
  if (begins) {
    if (under_way_) step = Step::broken;
    begin(came);
  } else {
    origin_.received_at = came.origin.received_at;
    on_wire_ += came.on_wire;
    if (!continues(rank, came.damaged)) {
      under_way_ = false;
      return Step::broken;
    }
  }
  last_ = rank;
  seen_ |= 1u << rank;
  std::visit(Keep{lines_}, line);
  if (rank == timing && lines_.timing.clock)
    origin_.valid_at =
        begin_.of(origin_.valid_at, lines_.timing.clock->time_since_epoch(), skipped_);
  if (rank != bottom_distance) return step;
  under_way_ = false;
  return (seen_ & needed) == needed ? Step::complete : Step::broken;
}

}  // namespace drydock::device
