#include "hil/sensor/dvl.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::sensor {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using BeamVelocities = std::array<std::optional<double>, 4>;

constexpr double farthest_fade = 1.25;  // factor on the longest range; beyond it fading gives no
                                        // echo

/// A head at the surface must not leave the water by rounding.
constexpr double awash_m = 1e-3;

/// docs/world/ocean.md (12)
double echo_snr_db(const JanusHead& head, double range_m) {
  return detection_snr_db + 20 * std::log10(head.longest_range_m / range_m) +
         2 * head.absorption_dbpm * (head.longest_range_m - range_m);
}

Vector3d turned(const JanusHead& head, const Vector3d& v) {
  if (head.turn_rad == 0) return v;  // to the last bit
  return Eigen::AngleAxisd(head.turn_rad, Vector3d::UnitZ()) * v;
}

struct JanusSolution {
  std::optional<Vector3d> velocity;
  std::optional<double> error_mps;  ///< only with four beams
};

/// docs/world/ocean.md (13). With three beams, (14) gives the fourth.
JanusSolution solve(BeamVelocities b, const JanusHead& head) {
  const auto bad = std::ranges::count_if(b, [](const auto& beam) { return !beam; });
  if (bad > 4 - head.fewest_beams || bad > 1) return {};
  for (std::size_t i = 0; i < 4 && bad; ++i)
    if (!b[i]) b[i] = *b[i ^ 2] + *b[i ^ 3] - *b[i ^ 1];
  const double s = std::sin(head.beam_angle_rad), c = std::cos(head.beam_angle_rad);
  JanusSolution solution;
  const Vector3d along_beams{(*b[2] - *b[3]) / (2 * s), (*b[1] - *b[0]) / (2 * s),
                             (*b[0] + *b[1] + *b[2] + *b[3]) / (4 * c)};
  solution.velocity = turned(head, along_beams);
  if (bad == 0)
    solution.error_mps = (*b[2] + *b[3] - *b[0] - *b[1]) / (2 * std::numbers::sqrt2 * s);
  return solution;
}

/// docs/world/ocean.md (15): uses every complete pair of opposite beams. If each pair has lost one
/// beam, it uses the remaining beams.
double altitude(const std::array<std::optional<double>, 4>& range_m, double cosine_of_tilt) {
  double inverse = 0, pairs = 0, sum = 0, beams = 0;
  for (const std::size_t i : {0U, 2U})
    if (range_m[i] && range_m[i + 1]) {
      inverse += 1 / *range_m[i] + 1 / *range_m[i + 1];
      ++pairs;
    }
  for (const auto& range : range_m)
    if (range) {
      sum += *range;
      ++beams;
    }
  return cosine_of_tilt * (pairs > 0 ? 2 * pairs / inverse : sum / beams);
}

/// One ping: place, attitude and motion of the head.
class Sounding {
 public:
  Sounding(const motion::Trajectory& trajectory, const Truth& truth, const Mounting& mounting,
           const JanusHead& head)
      : ocean_(trajectory.ocean()),
        t_s_(measurement::seconds(truth.at - trajectory.start())),
        head_(head),
        place_(place_of(truth, mounting)),
        to_ned_(truth.body_to_ned * mounting.sensor_to_body),
        velocity_(velocity_at(truth, mounting)),
        directions_(beam_directions(head)) {
    for (std::size_t i = 0; i < 4; ++i)
      bed_m_[i] = ocean_.bed_range_m(place_, to_ned_ * directions_[i], sight_m());
  }

  void bottom_track(const PingNoise& noise, DvlPing& ping) const {
    BeamVelocities velocities;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!bed_m_[i] || *bed_m_[i] < head_.shortest_range_m || under_air()) continue;
      const double snr = echo_snr_db(head_, *bed_m_[i]) + noise.fade_db[i];
      if (snr < detection_snr_db) continue;
      velocities[i] = directions_[i].dot(velocity_) + noise.bed_mps[i];
      ping.beams[i] = {bed_m_[i], velocities[i], snr};
      ping.range_m[i] = *bed_m_[i] * std::cos(head_.beam_angle_rad);
    }
    const JanusSolution solution = solve(velocities, head_);
    ping.velocity = solution.velocity;
    ping.error_velocity_mps = solution.error_mps;
    if (ping.velocity) ping.altitude_m = altitude(ping.range_m, to_ned_(2, 2));
  }

  void water_track(const PingNoise& noise, DvlPing& ping) const {
    if (!head_.layer) return;
    BeamVelocities velocities;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto water_ned = water_along(i);
      if (!water_ned) continue;
      const Vector3d through = velocity_ - to_ned_.transpose() * *water_ned;
      velocities[i] = directions_[i].dot(through) + noise.water_mps[i];
      ping.water.beam_good[i] = true;
    }
    const JanusSolution solution = solve(velocities, head_);
    ping.water.velocity = solution.velocity;
    ping.water.error_velocity_mps = solution.error_mps;
  }

  const Matrix3d& to_ned() const { return to_ned_; }

 private:
  double layer_end_m() const {
    return head_.layer ? (head_.layer->start_m + head_.layer->thickness_m) / cosine() : 0;
  }
  double sight_m() const { return std::max(farthest_fade * head_.longest_range_m, layer_end_m()); }
  double cosine() const { return std::cos(head_.beam_angle_rad); }
  bool under_air() const { return place_.height_m > awash_m; }

  /// Mean current along the beam's path through the layer. Empty if the path meets the bed or
  /// leaves the water.
  std::optional<Vector3d> water_along(std::size_t beam) const {
    const double end_m = layer_end_m();
    if (bed_m_[beam] && *bed_m_[beam] <= end_m) return std::nullopt;
    const double down = to_ned_.row(2).dot(directions_[beam]), depth = -place_.height_m;
    const double first = depth + down * head_.layer->start_m / cosine();
    const double last = depth + down * end_m;
    const bool in_bed = depth >= ocean_.bed_depth_m(place_.latitude_rad, place_.longitude_rad);
    if (under_air() || in_bed || std::min(first, last) < -awash_m) return std::nullopt;
    return ocean_.mean_current_ned(first, last, t_s_);
  }

  const ocean::Ocean& ocean_;
  double t_s_;
  const JanusHead& head_;
  frame::Position place_;
  Matrix3d to_ned_;
  Vector3d velocity_;
  std::array<Vector3d, 4> directions_;
  std::array<std::optional<double>, 4> bed_m_;  ///< along each beam
};

void scale(std::optional<double>& value, double by) {
  if (value) *value *= by;
}

/// What the head makes of the same echoes with another speed of sound.
void believe(double sound_speed_mps, DvlPing& ping) {
  const double by = sound_speed_mps / ping.sound_speed;
  if (ping.velocity) *ping.velocity *= by;
  if (ping.water.velocity) *ping.water.velocity *= by;
  scale(ping.error_velocity_mps, by);
  scale(ping.water.error_velocity_mps, by);
  scale(ping.altitude_m, by);
  for (auto& range : ping.range_m) scale(range, by);
  for (auto& beam : ping.beams) {
    scale(beam.range_m, by);
    scale(beam.velocity_mps, by);
  }
  ping.sound_speed = sound_speed_mps;
}

}  // namespace

std::array<Vector3d, 4> beam_directions(const JanusHead& head) {
  const double s = std::sin(head.beam_angle_rad), c = std::cos(head.beam_angle_rad);
  std::array<Vector3d, 4> beams{Vector3d{0, -s, c}, Vector3d{0, s, c}, Vector3d{s, 0, c},
                                Vector3d{-s, 0, c}};
  for (Vector3d& beam : beams) beam = turned(head, beam);
  return beams;
}

DvlPing dvl_ping(const motion::Trajectory& trajectory, Stamp at, const Mounting& mounting,
                 const JanusHead& head, const PingNoise& noise) {
  const Truth truth = trajectory.at(at);
  const Sounding sounding(trajectory, truth, mounting, head);
  DvlPing ping;
  ping.origin.valid_at = at;
  const frame::Euler attitude = frame::euler(Matrix3d(sounding.to_ned().transpose()));
  ping.heading_rad = attitude.yaw;
  ping.pitch_rad = attitude.pitch;
  ping.roll_rad = attitude.roll;
  ping.depth_m = depth_at(truth, mounting);
  ping.sound_speed = trajectory.ocean().sound_speed_mps(std::max(ping.depth_m, 0.0));
  sounding.bottom_track(noise, ping);
  sounding.water_track(noise, ping);
  if (head.set_sound_speed_mps) believe(*head.set_sound_speed_mps, ping);
  return ping;
}

}  // namespace drydock::sensor
