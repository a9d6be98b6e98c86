#include "hil/score/ros_covariances.hpp"

#include <fmt/format.h>

#include "hil/score/attitude.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/csv_covariance.hpp"
#include "hil/score/known_covariance.hpp"
#include "hil/score/turned.hpp"

namespace drydock::score {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;

void forget_angles(State& state, const std::array<bool, 3>& nothing) {
  for (Index i = 0; i < 3; ++i) {
    if (!nothing.at(static_cast<std::size_t>(i))) continue;
    state.angles[i] = untold()[i];
    if (state.angles_rad2) (*state.angles_rad2)(i, i) = untold()[i];
  }
}

}  // namespace

void tell_ros_covariances(const CsvHead& head,
                          const std::function<double(const std::string&)>& number,
                          const std::function<void(const std::string&)>& note, State& state) {
  const auto block = [&](const char* of, std::size_t first) -> std::optional<Matrix3d> {
    if (!head.has(covariance_column(of, first, first))) return {};
    Matrix3d numbers;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        numbers(static_cast<Index>(row), static_cast<Index>(column)) =
            number(covariance_column(of, first + row, first + column));
    return numbers;
  };
  const auto known = [&](const char* of, const Matrix3d& covariance) {
    const auto found = known_covariance(covariance);
    if (!found.matrix) note(fmt::format("the covariance of its {} {}", of, found.flaw));
    return found.matrix;
  };
  if (const auto told = block(csv_pose_covariance, 0); told && head.has_any(csv_local))
    state.position_m2 = turned(enu_to_ned, known("position", *told));
  if (const auto turns = block(csv_pose_covariance, 3); turns && head.has_enu_quaternion()) {
    const auto covariance = known("attitude", *turns);
    if (covariance && covariance->allFinite())
      state.angles_rad2 = turned(angles_by_turns(state.angles) * enu_to_ned, covariance);
    forget_angles(state, angles_of_nothing(*turns, number(csv_enu_quaternion[0]) == 1));
  }
  if (const auto told = block(csv_twist_covariance, 0); told && state.velocity_in_body)
    state.velocity_m2ps2 = turned(flu_to_frd, known("velocity", *told));
}

}  // namespace drydock::score
