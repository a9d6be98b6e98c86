#include "estimators/external/estimate_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drivers/measurement/covariance.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::external {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<std::string_view, 15> keys{"valid_at_ns",
                                                "roll_deg",
                                                "pitch_deg",
                                                "heading_deg",
                                                "latitude_deg",
                                                "longitude_deg",
                                                "height_m",
                                                "velocity_ned_mps",
                                                "attitude_sigma_deg",
                                                "position_sigma_m",
                                                "velocity_sigma_mps",
                                                "attitude_covariance_deg2",
                                                "position_covariance_m2",
                                                "velocity_covariance_m2ps2",
                                                "valid"};

}  // namespace

void EstimateReader::fail(Flaw flaw, std::string what) {
  if (flaw_ != Flaw::none) return;
  flaw_ = flaw;
  what_ = std::move(what);
}

double EstimateReader::number(const nlohmann::json& value, const char* key) {
  const double read = value.is_number() ? value.get<double>() : not_given;
  if (!value.is_number() && !value.is_null())
    fail(Flaw::malformed, fmt::format("{} that is not a number", key));
  else if (!std::isfinite(read))
    fail(Flaw::not_finite, fmt::format("{} that is not finite", key));
  return read;
}

double EstimateReader::within(const char* key, double limit) {
  const double read = number(estimate_[key], key);
  if (std::abs(read) > limit)
    fail(Flaw::malformed, fmt::format("{} = {}, allowed: -{} to {}", key, read, limit, limit));
  return read;
}

/// A program may count its turns: -180 to 180.
double EstimateReader::turns(const char* key) {
  return std::remainder(number(estimate_[key], key), 360);
}

bool EstimateReader::yes_or_no(const char* key) {
  const nlohmann::json& value = estimate_[key];
  if (!value.is_boolean())
    fail(Flaw::malformed, fmt::format("{} that is neither true nor false", key));
  return value == nlohmann::json(true);
}

Vector3d EstimateReader::three(const char* key) {
  const nlohmann::json& value = estimate_[key];
  if (value.is_array() && value.size() == 3)
    return {number(value[0], key), number(value[1], key), number(value[2], key)};
  fail(Flaw::malformed, fmt::format("{} that has not 3 numbers", key));
  return Vector3d::Zero();
}

Matrix3d EstimateReader::nine(const char* key) {
  Matrix3d read = Matrix3d::Zero();
  const nlohmann::json& rows = estimate_[key];
  if (!rows.is_array() || rows.size() != 9) {
    fail(Flaw::malformed, fmt::format("{} that has not 9 numbers", key));
    return read;
  }
  for (Eigen::Index i = 0; i < 9; ++i)
    read(i / 3, i % 3) = number(rows[static_cast<std::size_t>(i)], key);
  return read;
}

/// The diagonal of three standard deviations.
Matrix3d EstimateReader::squares(const char* key) {
  const Vector3d sigmas = three(key);
  if ((sigmas.array() < 0).any()) fail(Flaw::malformed, fmt::format("{} that is negative", key));
  return sigmas.cwiseAbs2().asDiagonal();
}

/// Three standard deviations, or nine numbers row by row; both, if they say the same.
std::optional<Matrix3d> EstimateReader::covariance(const char* sigma, const char* full,
                                                   double unit) {
  if (!has(sigma) && !has(full)) return {};
  const Matrix3d read = has(full) ? nine(full) : squares(sigma);
  if (has(sigma) && has(full)) {
    const Eigen::Array3d stated = squares(sigma).diagonal();
    if (!((read.diagonal().array() - stated).abs() <= 1e-6 * stated).all())
      fail(Flaw::malformed, fmt::format("{} and {} that disagree", sigma, full));
  }
  if (const char* flaw = measurement::covariance_flaw(read))
    fail(Flaw::malformed,
         fmt::format("{} that is no covariance: it {}", has(full) ? full : sigma, flaw));
  return read * unit * unit;
}

std::optional<Vector3d> EstimateReader::angles() {
  if (!has("roll_deg") || !has("pitch_deg")) return {};
  const double heading = has("heading_deg") ? turns("heading_deg") : not_given;
  return Vector3d{within("roll_deg", 360), within("pitch_deg", 90), heading} * units::degree;
}

std::optional<frame::Position> EstimateReader::position() {
  if (!has("latitude_deg") || !has("longitude_deg")) return {};
  return frame::Position{within("latitude_deg", 90) * units::degree,
                         within("longitude_deg", 360) * units::degree,
                         has("height_m") ? number(estimate_["height_m"], "height_m") : not_given};
}

Values EstimateReader::values() {
  Values values;
  values.valid_at = measurement::stamp_from_ns(estimate_["valid_at_ns"].get<std::int64_t>());
  values.roll_pitch_heading_rad = angles();
  values.position = position();
  if (has("velocity_ned_mps")) values.velocity_ned_mps = three("velocity_ned_mps");
  values.attitude_rad2 =
      covariance("attitude_sigma_deg", "attitude_covariance_deg2", units::degree);
  values.position_m2 = covariance("position_sigma_m", "position_covariance_m2", 1);
  values.velocity_m2ps2 = covariance("velocity_sigma_mps", "velocity_covariance_m2ps2", 1);
  values.valid = !has("valid") || yes_or_no("valid");
  return values;
}

/// A key that is not read was meant to say something.
void EstimateReader::must_know_its_keys() {
  for (const auto& [key, value] : estimate_.items())
    if (std::ranges::find(keys, key) == keys.end())
      fail(Flaw::malformed,
           fmt::format("the key {}, allowed: {}", text::printable(key), fmt::join(keys, ", ")));
}

void EstimateReader::must_give(const Values& values) {
  if (gives_ == Gives::attitude && !values.roll_pitch_heading_rad)
    fail(Flaw::malformed, "an estimate without roll_deg and pitch_deg");
  if (gives_ == Gives::navigation && !values.position)
    fail(Flaw::malformed, "an estimate without latitude_deg and longitude_deg");
  if (gives_ == Gives::velocity && !values.velocity_ned_mps)
    fail(Flaw::malformed, "an estimate without velocity_ned_mps");
}

pipeline::OutsideEstimate EstimateReader::read() {
  if (!estimate_.is_object() || !has("valid_at_ns") ||
      !estimate_["valid_at_ns"].is_number_integer()) {
    fail(Flaw::malformed, "an estimate without valid_at_ns, a whole number");
    return {};
  }
  const Values read = values();
  must_give(read);
  must_know_its_keys();
  return flaw_ == Flaw::none ? estimate_of(read, gives_) : pipeline::OutsideEstimate{};
}

}  // namespace drydock::external
