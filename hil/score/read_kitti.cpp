#include <fmt/format.h>

#include <fstream>

#include "hil/score/attitude.hpp"
#include "hil/score/csv_cells.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/words_of.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::score {
namespace {

/// A camera's right, down, forward to forward, right, down.
const Eigen::Matrix3d camera_to_frd{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};

boost::system::result<State, Problem> kitti_pose(const std::vector<std::string>& words) {
  if (words.size() != kitti_numbers)
    return Problem{fmt::format("{} numbers, allowed: the 12 of a 3 x 4 matrix", words.size())};
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> matrix;
  for (std::size_t i = 0; i < kitti_numbers; ++i) {
    const auto value = number_of(words[i]);
    if (!value) return Problem{fmt::format("\"{}\" is no number", words[i])};
    matrix.data()[i] = *value;
  }
  const Eigen::Matrix3d turn = matrix.leftCols<3>();
  if (!matrix.allFinite() || !(turn * turn.transpose()).isIdentity(0.02))
    return Problem{"the first three columns are no rotation"};
  State state;
  state.position_ned = camera_to_frd * matrix.col(3);
  state.angles =
      angles_of(Eigen::Quaterniond(camera_to_frd * turn * camera_to_frd.transpose()).normalized());
  return state;
}

boost::system::result<std::vector<measurement::Stamp>, Problem> kitti_times(
    const std::string& path) {
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return Problem{fmt::format("{}: {}", path, why)};
  std::ifstream in(path);
  std::vector<measurement::Stamp> times;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(number == 1 ? without_byte_order_mark(line) : line);
    if (words.empty()) continue;
    const auto at = words.size() == 1 ? stamp_of_any(words[0]) : std::nullopt;
    if (!at) return Problem{fmt::format("{}:{}: not one time", path, number)};
    times.push_back(*at);
  }
  return times;
}

}  // namespace

boost::system::result<Estimates, Problem> read_kitti(std::istream& in, const std::string& name,
                                                     const std::string& times_path) {
  if (times_path.empty())
    return Problem{fmt::format(
        "{}: poses of KITTI have no times; give --times FILE with the time of each, a line each",
        name)};
  const auto times = kitti_times(times_path);
  if (!times) return times.error();
  Estimates out;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto words = words_of(number == 1 ? without_byte_order_mark(line) : line);
    if (words.empty()) continue;
    auto pose = kitti_pose(words);
    if (!pose) return Problem{fmt::format("{}:{}: {}", name, number, pose.error().line)};
    if (out.track.size() < times->size()) pose->at = (*times)[out.track.size()];
    out.track.push_back(*pose);
  }
  if (out.track.size() != times->size())
    return Problem{fmt::format("{} has {} poses, and {} has {} times", name, out.track.size(),
                               times_path, times->size())};
  out.notes.emplace_back(
      "the poses are those of a camera (right, down, forward) from its first one: --align yaw or "
      "rigid turns them to north");
  return out;
}

}  // namespace drydock::score
