#include "drivers/device/dvl/nortek_ad2cp_driver.hpp"

#include <algorithm>

#include "drivers/device/dvl/dvl_solution.hpp"
#include "drivers/device/dvl/velocity_accuracy.hpp"

namespace drydock::device {
namespace {

using wire::ad2cp::BottomTrack;
using wire::ad2cp::Four;
using wire::ad2cp::SignatureBottomTrack;

/// Empty if no ping takes so long.
std::optional<std::chrono::nanoseconds> within_a_ping(std::optional<double> s) {
  constexpr double longest_s = 2;
  if (!s || !(*s >= 0 && *s <= longest_s)) return {};
  return measurement::from_seconds(*s);
}

/// Time between the bottom's echo and the first byte of the output.
std::optional<std::chrono::nanoseconds> age_of(const Ad2cpSolution& solution) {
  return within_a_ping(wire::scaled(solution.after_output_s, -1));
}

/// Beams 1 and 3 look into opposite directions, and so do 2 and 4.
std::optional<double> altitude_of(const Four& distance_m, const wire::DvlAttitude& tilt) {
  const auto& [first, second, third, fourth] = distance_m;
  return altitude_over_bed({first, third, second, fourth}, tilt);
}

bool has_any(const Four& values) {
  return std::ranges::any_of(values, [](const auto& value) { return value.has_value(); });
}

/// What keeps a Signature's velocity from being the vehicle's.
std::string_view trouble_of(const SignatureBottomTrack& record, std::optional<bool> of_bed) {
  if (!has_any(record.velocity_mps)) return "";
  if (!of_bed)
    return "no velocity: no document tells the sign of a Signature's bottom track (17); drive "
           "ahead, look at it with drydock decode, and set velocity_of to vehicle or bed";
  if (record.axes != wire::ad2cp::Axes::instrument)
    return "no velocity: a Signature's bottom track (17) has to be in axes X, Y, Z: set it so";
  const auto& [x, y, z1, z2] = record.velocity_mps;
  return x && y && (z1 || z2) ? "" : "no velocity: the Signature gives some axes, but not all";
}

std::string_view trouble_of(const BottomTrack& record, const Ad2cpSolution& solution) {
  if (record.error != 0) return "the DVL reports an error: the error word of its record is not 0";
  if (solution.velocity || !has_any(record.axes.velocity_mps)) return "";
  return "no velocity: the DVL gives some axes, but not X, Y and a Z";
}

}  // namespace

void NortekAd2cpDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::NortekAd2cp::decode(frame);
  if (!message) return;
  std::visit(
      [&](const auto& record) {
        if constexpr (requires { on(record, arrival, out); }) on(record, arrival, out);
      },
      *message);
}

void NortekAd2cpDriver::on(const BottomTrack& record, const Arrival& arrival, Output& out) {
  const Ad2cpSolution solution = solve(record.axes);
  heed(trouble_of(record, solution), out);
  measurement::BottomVelocity result;
  result.origin = origin_of(solution, record, arrival);
  if (solution.velocity) result.velocity = mounting_.to_body(*solution.velocity);
  if (solution.covariance)
    result.velocity_covariance = mounting_.covariance_to_body(*solution.covariance);
  result.error_velocity_mps = solution.error_velocity_mps;
  result.range_m = record.distance_m;
  result.altitude_m = altitude_of(record.distance_m, {{}, 0.0, 0.0});
  result.sound_speed_mps = record.sound_speed_mps;
  finish_.publish(result, {record.temperature_k, {}}, out);
}

void NortekAd2cpDriver::on(const SignatureBottomTrack& record, const Arrival& arrival,
                           Output& out) {
  const auto trouble = trouble_of(record, of_bed_);
  heed(trouble, out);
  measurement::BottomVelocity result;
  result.origin = timing_.of_bytes(arrival);
  if (record.clock) result.origin.device_time = *record.clock;
  if (trouble.empty() && has_any(record.velocity_mps)) {
    wire::ad2cp::Estimates axes;
    for (std::size_t i = 0; i < 4; ++i)
      axes.velocity_mps[i] = wire::scaled(record.velocity_mps[i], *of_bed_ ? -1 : 1);
    const Ad2cpSolution solution = solve(axes);
    result.velocity = mounting_.to_body(*solution.velocity);
    result.error_velocity_mps = solution.error_velocity_mps;
  }
  result.heading_rad = record.heading_rad;
  result.pitch_rad = record.pitch_rad;
  result.roll_rad = record.roll_rad;
  result.range_m = record.distance_m;
  result.altitude_m =
      altitude_of(record.distance_m, {record.heading_rad, record.pitch_rad, record.roll_rad});
  result.sound_speed_mps = record.sound_speed_mps;
  finish_.publish(result, {record.temperature_k, {}}, out);
}

/// The clock of a record shows its trigger; the echo came later.
Origin NortekAd2cpDriver::origin_of(const Ad2cpSolution& solution, const BottomTrack& record,
                                    const Arrival& arrival) {
  const auto age = echo_.age(age_of(solution));
  Origin origin = age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival);
  if (record.clock)
    origin.device_time =
        *record.clock + echo_.after_trigger(within_a_ping(solution.after_trigger_s));
  return origin;
}

void NortekAd2cpDriver::heed(std::string_view trouble, Output& out) {
  if (!trouble.empty() && trouble != trouble_) out.report(trouble);
  trouble_ = trouble;
}

}  // namespace drydock::device
