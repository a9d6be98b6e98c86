#include "hil/compare/true_places.hpp"

namespace drydock::compare {

std::vector<frame::Position> true_places(const motion::Trajectory& truth, measurement::Stamp end) {
  constexpr int points = 1000;
  std::vector<frame::Position> places;
  for (int i = 0; i <= points; ++i) {
    const auto at = truth.at(truth.start() + i * (end - truth.start()) / points);
    places.push_back({at.latitude_rad, at.longitude_rad, at.height_m});
  }
  return places;
}

}  // namespace drydock::compare
