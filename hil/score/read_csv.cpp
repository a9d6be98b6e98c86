#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/score/csv_head.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/passed_over.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

/// Seconds as a double are off by 0.2 us.
constexpr std::chrono::microseconds same_time{1};

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
    if (head_.has(csv_geodetic))
      if (auto why = no_place(three(csv_geodetic)); !why.empty()) return why;
    const auto at = time();
    const Vector3d position = place();
    if (!at || !position.allFinite()) return "a time or a position is no number";
    out_.track.push_back({*at, position, attitude(), covariance()});
    return {};
  }

  Estimates result() {
    out_.notes = head_.incomplete();
    std::ranges::move(passed_over_.notes(), std::back_inserter(out_.notes));
    return std::move(out_);
  }

 private:
  void note(const std::string& why) { passed_over_.add(why, number_); }
  const std::string& cell(const char* name) const { return cells_[head_.at(name)]; }
  Vector3d three(const CsvGroup& group) const {
    Vector3d values;
    for (Eigen::Index i = 0; i < 3; ++i)
      values[i] = number_of(cell(group.at(static_cast<std::size_t>(i))))
                      .value_or(std::numeric_limits<double>::quiet_NaN());
    return values;
  }

  /// Columns in each other's place often show here: a longitude may be above 90.
  static std::string no_place(const Vector3d& geodetic) {
    if (std::abs(geodetic.x()) > 90)
      return fmt::format("latitude_deg = {}, allowed: -90 to 90", geodetic.x());
    if (std::abs(geodetic.y()) > 360)
      return fmt::format("longitude_deg = {}, allowed: -360 to 360", geodetic.y());
    return {};
  }

  std::optional<measurement::Stamp> time() {
    const bool has_ns = head_.has("valid_at_ns"), has_s = head_.has("t_s");
    const auto ns = has_ns ? stamp_of_nanoseconds(cell("valid_at_ns")) : std::nullopt;
    const auto s = has_s ? stamp_of_seconds(cell("t_s")) : std::nullopt;
    if (has_ns && has_s && ns && !(s && std::chrono::abs(*s - *ns) <= same_time))
      note("t_s is not the time of valid_at_ns, which is taken");
    return has_ns ? ns : s;
  }

  /// Metres count from the first truth. A file may have them on a plane: 1 in 1000 is no
  /// disagreement.
  Vector3d place() {
    const bool has_local = head_.has(csv_local), has_geodetic = head_.has(csv_geodetic);
    Vector3d local = has_local ? three(csv_local) : Vector3d::Zero();
    if (!has_geodetic) return local;
    const Vector3d v = three(csv_geodetic);
    Vector3d geodetic =
        frame::ned_offset(origin_, {v.x() * units::degree, v.y() * units::degree, v.z()});
    if (!has_local) return geodetic;
    if (!((geodetic - local).norm() <= 0.1 + 1e-3 * local.norm()))
      note(
          "latitude_deg, longitude_deg, height_m are not the place of north_m, east_m, down_m, "
          "which are taken");
    return local;
  }

  /// An empty cell says that there is none.
  std::optional<Eigen::Quaterniond> attitude() {
    if (!head_.has(csv_angles)) return {};
    const Vector3d angles = three(csv_angles) * units::degree;
    if (angles.allFinite()) return frame::body_to_ned({angles.x(), angles.y(), angles.z()});
    note("an angle is no number, the attitude is left out");
    return {};
  }

  std::optional<Eigen::Matrix3d> covariance() {
    if (!head_.has(csv_sigmas)) return {};
    const Vector3d sigmas = three(csv_sigmas);
    if (sigmas.allFinite() && (sigmas.array() > 0).all())
      return Eigen::Matrix3d(sigmas.cwiseAbs2().asDiagonal());
    note("a standard deviation is not above 0, the covariance is left out");
    return {};
  }

  const CsvHead& head_;
  const frame::Position& origin_;
  std::uint64_t number_ = 0;
  std::vector<std::string> cells_;
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
