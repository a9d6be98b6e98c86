#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "drivers/text/printable.hpp"
#include "drivers/text/utc.hpp"
#include "hil/score/attitude.hpp"
#include "hil/score/csv_head.hpp"
#include "hil/score/geodetic_place.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/passed_over.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;
using namespace std::chrono_literals;

/// By csv_times: seconds as a double are off by 0.2 us, a text has milliseconds.
constexpr std::array<std::chrono::microseconds, 3> same_time{0us, 1us, 1000us};
constexpr double same_attitude_rad = 1e-3;

class CsvReader {
 public:
  CsvReader(const CsvHead& head, const frame::Position& origin) : head_(head), origin_(origin) {}

  /// Why the line cannot be one of a track; empty: it can.
  std::string read(const std::string& text, std::uint64_t number) {
    number_ = number;
    cells_ = csv_cells(text);
    while (cells_.size() > head_.size() && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() != head_.size()) {
      note(fmt::format("not the {} cells of line 1, left out", head_.size()));
      return {};
    }
    State state;
    state.at = time().value_or(state.at);
    state.position_ned = place();
    state.angles = angles();
    state.velocity_in_body = !head_.has_any(csv_velocity) && head_.has_any(csv_body_velocity);
    state.velocity = three(state.velocity_in_body ? csv_body_velocity : csv_velocity);
    state.position_m2 = position_covariance();
    state.angles_rad2 = covariance(csv_angle_sigmas, units::degree);
    state.velocity_m2ps2 =
        covariance(state.velocity_in_body ? csv_body_velocity_sigmas : csv_velocity_sigmas, 1);
    if (!wrong_.empty()) return wrong_;
    if (state.says_anything())
      out_.track.push_back(state);
    else
      note("it has a time and nothing else, left out");
    return {};
  }

  Estimates result() {
    out_.notes = head_.incomplete();
    std::ranges::move(passed_over_.notes(), std::back_inserter(out_.notes));
    return std::move(out_);
  }

 private:
  void note(const std::string& why) { passed_over_.add(why, number_); }
  void refuse(std::string why) {
    if (wrong_.empty()) wrong_ = std::move(why);
  }
  const std::string& cell(const char* name) const { return cells_[head_.at(name)]; }

  /// NaN where there is no such column, or an empty cell.
  double number(const char* name) {
    constexpr double nobody = std::numeric_limits<double>::quiet_NaN();
    if (!head_.has(name) || cell(name).empty()) return nobody;
    const auto value = number_of(cell(name));
    if (value && !std::isinf(*value)) return *value;
    refuse(fmt::format("{} = \"{}\" is no number", name, text::printable(cell(name))));
    return nobody;
  }
  Vector3d three(const CsvGroup& group) {
    return {number(group[0]), number(group[1]), number(group[2])};
  }

  std::optional<measurement::Stamp> time() {
    const auto told = [&](const char* name, const auto& parse) {
      return head_.has(name) ? parse(cell(name)) : std::nullopt;
    };
    const std::array times{told(csv_times[0], stamp_of_nanoseconds),
                           told(csv_times[1], stamp_of_seconds),
                           told(csv_times[2], text::parse_utc)};
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(csv_times, [&](const char* name) { return head_.has(name); }) -
        csv_times.begin());
    const auto at = times[first];
    if (!at)
      refuse(fmt::format("{} = \"{}\" is no time", csv_times[first],
                         text::printable(cell(csv_times[first]))));
    for (std::size_t other = first + 1; at && other < times.size(); ++other)
      if (head_.has(csv_times[other]) &&
          !(times[other] && std::chrono::abs(*times[other] - *at) <= same_time[other]))
        note(fmt::format("{} is not the time of {}, which is taken", csv_times[other],
                         csv_times[first]));
    return at;
  }

  /// Without a height the place is at that of the origin, and down is not told.
  Vector3d geodetic() {
    const Vector3d v = three(csv_geodetic);
    // Columns in each other's place often show here: a longitude may be above 90.
    if (std::abs(v.x()) > 90) refuse(fmt::format("latitude_deg = {}, allowed: -90 to 90", v.x()));
    if (std::abs(v.y()) > 360)
      refuse(fmt::format("longitude_deg = {}, allowed: -360 to 360", v.y()));
    return place_of({v.x() * units::degree, v.y() * units::degree, v.z()}, origin_);
  }

  /// Metres count from the first truth. A file may have them on a plane: 1 in 1000 is no
  /// disagreement.
  Vector3d place() {
    const bool has_local = head_.has_any(csv_local);
    Vector3d local = three(csv_local);
    if (!head_.has_geodetic() && !head_.has(csv_geodetic[2])) return local;
    Vector3d from_degrees = geodetic();
    if (!has_local) return from_degrees;
    if ((from_degrees - local).norm() > 0.1 + 1e-3 * local.norm())
      note(
          "latitude_deg, longitude_deg, height_m are not the place of north_m, east_m, down_m, "
          "which are taken");
    return local.array().isNaN().select(from_degrees, local);
  }

  Vector3d angles() {
    Vector3d told = three(csv_angles) * units::degree;
    if (!head_.has_quaternion()) return told;
    const Vector3d turned = angles_of_quaternion();
    if ((turns_between(told, turned).array().abs() > same_attitude_rad).any())
      note("qw, qx, qy, qz are not roll_deg, pitch_deg, heading_deg, which are taken");
    return told.array().isNaN().select(turned, told);
  }

  Vector3d angles_of_quaternion() {
    const Eigen::Quaterniond q(number("qw"), number("qx"), number("qy"), number("qz"));
    if (q.coeffs().hasNaN()) return untold();
    if (std::abs(q.norm() - 1) < 0.01) return angles_of(q.normalized());
    note("the length of qw, qx, qy, qz is not 1, the attitude is left out");
    return untold();
  }

  /// An empty cell says that there is none.
  std::optional<Eigen::Matrix3d> covariance(const CsvGroup& sigmas_of, double unit) {
    const Vector3d sigmas = three(sigmas_of) * unit;
    if (sigmas.array().isNaN().all()) return {};
    if (!(sigmas.array() <= 0).any()) return Eigen::Matrix3d(sigmas.cwiseAbs2().asDiagonal());
    note("a standard deviation is not above 0, the covariance is left out");
    return {};
  }

  std::optional<Eigen::Matrix3d> position_covariance() {
    auto told = covariance(csv_local_sigmas, 1);
    const double correlation = number(csv_correlation);
    if (!told || std::isnan(correlation)) return told;
    if (std::abs(correlation) >= 1) {
      note(fmt::format("{} is not between -1 and 1, the covariance is left out", csv_correlation));
      return {};
    }
    (*told)(0, 1) = (*told)(1, 0) = correlation * std::sqrt((*told)(0, 0) * (*told)(1, 1));
    return told;
  }

  const CsvHead& head_;
  const frame::Position& origin_;
  std::uint64_t number_ = 0;
  std::vector<std::string> cells_;
  std::string wrong_;
  PassedOver passed_over_{"line"};
  Estimates out_;
};

}  // namespace

boost::system::result<Estimates, Problem> read_csv(std::istream& in, const std::string& name,
                                                   const frame::Position& origin) {
  std::string text;
  std::getline(in, text);
  const CsvHead head(without_byte_order_mark(text));
  if (const auto wrong = head.misfit(); !wrong.empty())
    return Problem{fmt::format("{}:1: {}", name, wrong)};
  CsvReader reader(head, origin);
  for (std::uint64_t number = 2; std::getline(in, text); ++number) {
    if (text.empty() || text == "\r") continue;
    if (const auto why = reader.read(text, number); !why.empty())
      return Problem{fmt::format("{}:{}: {}", name, number, why)};
  }
  return reader.result();
}

}  // namespace drydock::score
