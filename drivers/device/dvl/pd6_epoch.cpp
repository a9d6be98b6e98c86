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

void Pd6Epoch::begin(const Origin& origin, std::uint64_t damaged) {
  lines_ = {};
  origin_ = origin;
  began_ = origin.received_at;
  on_wire_ = {};
  damaged_ = damaged;
  seen_ = 0;
  under_way_ = true;
}

Pd6Epoch::Step Pd6Epoch::take(const wire::Pd6::Message& line, const Origin& origin,
                              std::chrono::nanoseconds on_wire, std::uint64_t damaged) {
  const std::size_t rank = line.index();
  const bool begins = rank == attitude || (rank == timing && !(under_way_ && last_ == attitude));
  if (!begins && !under_way_) return Step::idle;

  Step step = Step::under_way;
  if (begins) {
    if (under_way_) step = Step::broken;
    begin(origin, damaged);
  } else {
    origin_.received_at = origin.received_at;
    on_wire_ += on_wire;
    if (!continues(rank, damaged)) {
      forget();
      return Step::broken;
    }
  }
  last_ = rank;
  seen_ |= 1u << rank;
  std::visit(Keep{lines_}, line);
  if (rank != bottom_distance) return step;
  forget();
  return (seen_ & needed) == needed ? Step::complete : Step::broken;
}

}  // namespace drydock::device
