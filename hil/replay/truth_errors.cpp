#include "hil/replay/truth_errors.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::replay {

namespace {

constexpr std::size_t most_waiting = 4096;

frame::Position position_of(const bus::Navigation& n) {
  return {n.latitude_rad, n.longitude_rad, n.height_m};
}

double turn_rest(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }
double rms(double squares, std::uint64_t count) {
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

}  // namespace

void TruthErrors::on_estimate(const host::Estimate& e) {
  Waiting waiting{e.estimator, {}, e.attitude.roll_rad, e.attitude.pitch_rad};
  if (e.navigation) waiting.position = position_of(*e.navigation);
  waiting_.emplace(e.attitude.valid_at, waiting);
  if (waiting_.size() > most_waiting) waiting_.erase(waiting_.begin());
}

void TruthErrors::on_truth(const host::Estimate& truth) {
  compare_attitude(truth.attitude);
  if (truth.navigation) compare_position(truth.attitude.valid_at, position_of(*truth.navigation));
}

void TruthErrors::compare_attitude(const bus::Attitude& truth) {
  const auto [first, last] = waiting_.equal_range(truth.valid_at);
  for (auto it = first; it != last; ++it) {
    auto& sums = sums_[it->second.estimator];
    ++sums.attitudes;
    sums.roll2 += std::pow(turn_rest(it->second.roll_rad - truth.roll_rad), 2);
    sums.pitch2 += std::pow(it->second.pitch_rad - truth.pitch_rad, 2);
  }
  waiting_.erase(waiting_.begin(), first);
}

void TruthErrors::compare_position(Stamp at, const frame::Position& truth) {
  const auto [first, last] = waiting_.equal_range(at);
  for (auto it = first; it != last; ++it) {
    if (!it->second.position) continue;
    auto& sums = sums_[it->second.estimator];
    ++sums.positions;
    sums.horizontal2 += frame::ned_offset(truth, *it->second.position).head<2>().squaredNorm();
  }
}

TruthErrors::Rms TruthErrors::of(std::size_t estimator) const {
  const auto& s = sums_.at(estimator);
  return {s.attitudes, s.positions, rms(s.roll2, s.attitudes) * units::degrees_per_radian,
          rms(s.pitch2, s.attitudes) * units::degrees_per_radian, rms(s.horizontal2, s.positions)};
}

}  // namespace drydock::replay
