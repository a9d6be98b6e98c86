#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "drivers/text/printable.hpp"
#include "drivers/text/utc.hpp"
#include "hil/score/attitude.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/csv_cells.hpp"
#include "hil/score/csv_head.hpp"
#include "hil/score/csv_start.hpp"
#include "hil/score/geodetic_place.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/passed_over.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/ros_covariances.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;
using namespace std::chrono_literals;

/// By csv_times: seconds as a double are off by 0.2 us, a text has milliseconds.
constexpr std::array<std::chrono::microseconds, 3> same_time{0us, 1us, 1000us};
constexpr double same_attitude_rad = 1e-3;

/// A decimal comma is a point.
void with_point(std::string& cell) { std::ranges::replace(cell, ',', '.'); }

std::optional<measurement::Stamp> stamp_of_milliseconds(std::string_view text) {
  return stamp_of_decimal(text, 6);
}
std::optional<measurement::Stamp> stamp_of_microseconds(std::string_view text) {
  return stamp_of_decimal(text, 3);
}

class CsvReader {
 public:
  CsvReader(const CsvHead& head, const CsvStart& start, const frame::Position& origin)
      : head_(head), start_(start), origin_(origin) {}

  /// Why the line cannot be one of a track; empty: it can.
  std::string read(const std::string& text, std::uint64_t number) {
    number_ = number;
    cells_ = csv_cells(text, start_.separator);
    if (start_.separator != ',')
      for (auto& cell : cells_) with_point(cell);
    while (cells_.size() > head_.size() && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() != head_.size()) {
      note(fmt::format("not the {} cells of line {}, left out", head_.size(), start_.line));
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
    tell_ros_covariances(
        head_, [this](const std::string& name) { return this->number(name.c_str()); },
        [this](const std::string& why) { note(why); }, state);
    if (!wrong_.empty()) return wrong_;
    if (state.says_anything())
      out_.track.push_back(state);
    else
      note("it has a time and nothing else, left out");
    return {};
  }

  Estimates result() {
    out_.notes = head_.notes();
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
    if (value && !std::isinf(*value)) return *value * head_.factor(name);
    refuse(fmt::format("{} = \"{}\" is no number", name, text::printable(cell(name))));
    return nobody;
  }
  Vector3d three(const CsvGroup& group) {
    return {number(group[0]), number(group[1]), number(group[2])};
  }

  std::optional<measurement::Stamp> time() {
    if (std::ranges::none_of(csv_times, [&](const char* name) { return head_.has(name); }))
      return other_time();
    const std::array times{told(csv_times[0], stamp_of_nanoseconds),
                           told(csv_times[1], stamp_of_seconds), told(csv_times[2], stamp_of_any)};
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

  /// As others write it: two columns of a message, or one of which the number tells the unit.
  std::optional<measurement::Stamp> other_time() {
    const bool in_parts = head_.has(csv_second) && head_.has(csv_nanosecond);
    const std::array times{
        std::pair{csv_second, in_parts ? told(csv_second, stamp_of_seconds) : std::nullopt},
        std::pair{csv_stamp, told(csv_stamp, stamp_of_any)},
        std::pair{csv_milliseconds, told(csv_milliseconds, stamp_of_milliseconds)},
        std::pair{csv_microseconds, told(csv_microseconds, stamp_of_microseconds)},
        std::pair{csv_time, told(csv_time, stamp_of_any)}};
    const auto first = std::ranges::find_if(times, [&](const auto& time) {
      return head_.has(time.first) && (time.first != csv_second || in_parts);
    });
    if (first == times.end()) {
      refuse(fmt::format("{} needs {}", csv_nanosecond, csv_second));
      return {};
    }
    auto at = first->second;
    if (at && in_parts) {
      const auto part = told(csv_nanosecond, stamp_of_nanoseconds);
      at = part ? std::optional(*at + part->time_since_epoch()) : std::nullopt;
    }
    if (!at)
      refuse(
          fmt::format("{} = \"{}\" is no time", first->first, text::printable(cell(first->first))));
    return at;
  }
  template <class Parse>
  std::optional<measurement::Stamp> told(const char* name, const Parse& parse) {
    return head_.has(name) ? parse(cell(name)) : std::nullopt;
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
    const bool enu = head_.has_enu_quaternion();
    if (!enu && !head_.has_quaternion()) return told;
    const Vector3d turned = angles_of_quaternion(enu ? csv_enu_quaternion : csv_quaternion, enu);
    if ((turns_between(told, turned).array().abs() > same_attitude_rad).any())
      note("qw, qx, qy, qz are not roll_deg, pitch_deg, heading_deg, which are taken");
    return told.array().isNaN().select(turned, told);
  }

  Vector3d angles_of_quaternion(const std::array<const char*, 4>& names, bool enu) {
    const Eigen::Quaterniond q(number(names[0]), number(names[1]), number(names[2]),
                               number(names[3]));
    if (q.coeffs().hasNaN()) return untold();
    if (std::abs(q.norm() - 1) < 0.01) return angles_of(enu ? ned_of_enu(q) : q.normalized());
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
  const CsvStart& start_;
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
  const CsvStart start = start_of_csv(in);
  const CsvHead head(start.names);
  if (const auto wrong = head.misfit(); !wrong.empty())
    return Problem{fmt::format("{}:{}: {}", name, start.line, wrong)};
  CsvReader reader(head, start, origin);
  const auto read = [&](const std::string& text, std::uint64_t number) {
    if (text.empty() || text == "\r" || text.starts_with('#')) return std::string{};
    const auto why = reader.read(text, number);
    return why.empty() ? why : fmt::format("{}:{}: {}", name, number, why);
  };
  std::uint64_t number = start.at;
  if (auto why = read(start.first, number); !why.empty()) return Problem{why};
  std::string text;
  while (std::getline(in, text))
    if (auto why = read(text, ++number); !why.empty()) return Problem{why};
  return reader.result();
}

}  // namespace drydock::score
