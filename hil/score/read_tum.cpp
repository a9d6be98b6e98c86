#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "hil/score/attitude.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/csv_cells.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/words_of.hpp"

namespace drydock::score {
namespace {

boost::system::result<State, Problem> tum_pose(const std::vector<std::string>& words) {
  if (words.size() == kitti_numbers)
    return Problem{
        "12 numbers are a pose of KITTI, without a time: give --format kitti --times FILE"};
  if (words.size() != 8) return Problem{"not t x y z qx qy qz qw"};
  const auto at = stamp_of_seconds(words[0]);
  const auto number = [&](std::size_t i) {
    return number_of(words[i]).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  const Eigen::Vector3d position{number(1), number(2), number(3)};
  const Eigen::Quaterniond q(number(7), number(4), number(5), number(6));
  if (!at)
    return Problem{fmt::format("\"{}\" is no time in seconds (since 1970, or of the truth's clock)",
                               words[0])};
  if (!position.allFinite() || q.coeffs().hasNaN())
    return Problem{"a value of the pose is no number"};
  if (const double norm = q.norm(); !(std::abs(norm - 1) < 0.01))
    return Problem{fmt::format("the quaternion's length is {:.3g}, allowed: 0.99 to 1.01", norm)};
  return State{
      .at = *at, .position_ned = enu_to_ned * position, .angles = angles_of(ned_of_enu(q))};
}

}  // namespace

boost::system::result<Estimates, Problem> read_tum(std::istream& in, const std::string& name) {
  Estimates out;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(number == 1 ? without_byte_order_mark(line) : line);
    if (words.empty()) continue;
    const auto pose = tum_pose(words);
    if (!pose) return Problem{fmt::format("{}:{}: {}", name, number, pose.error().line)};
    out.track.push_back(*pose);
  }
  return out;
}

}  // namespace drydock::score
