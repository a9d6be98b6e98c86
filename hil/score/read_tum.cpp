#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "hil/score/axes.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

std::optional<Pose> tum_pose(const std::string& line) {
  std::istringstream words(line);
  std::string time;
  std::array<double, 7> v{};
  words >> time;
  for (double& value : v) words >> value;
  const auto at = stamp_of_seconds(time);
  if (!words || !at) return {};
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1) < 0.01)) return {};
  return Pose{*at, ned_of_enu(Eigen::Vector3d{v[0], v[1], v[2]}), ned_of_enu(q), {}};
}

}  // namespace

boost::system::result<Track, Problem> read_tum(std::istream& in, const std::string& name) {
  Track track;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line.front() == '#' || line == "\r") continue;
    const auto pose = tum_pose(line);
    if (!pose || !pose->position_ned.allFinite())
      return Problem{fmt::format("{}:{}: not t x y z qx qy qz qw", name, number)};
    track.push_back(*pose);
  }
  return track;
}

}  // namespace drydock::score
