#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

std::vector<std::string> cells_of(std::string line) {
  std::erase(line, '\r');
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else if (c != ' ' && c != '"') {
      cells.back().push_back(c);
    }
  }
  return cells;
}

/// The values of a line by the names of their columns.
class CsvLine {
 public:
  CsvLine(const std::vector<std::string>& names, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i)
      cells_[names[i]] = cells[i];
  }
  bool has(const char* name) const { return cells_.contains(name); }
  /// NaN: the cell is not there or no number.
  double at(const char* name) const {
    const auto found = cells_.find(name);
    return found == cells_.end() ? not_there : number_of(found->second).value_or(not_there);
  }
  std::optional<measurement::Stamp> time() const {
    if (const auto s = cells_.find("t_s"); s != cells_.end()) return stamp_of_seconds(s->second);
    const auto ns = cells_.find("valid_at_ns");
    const auto read = ns == cells_.end() ? std::nullopt : whole_number_of(ns->second);
    return read ? std::optional(measurement::stamp_from_ns(*read)) : std::nullopt;
  }

 private:
  static constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
  std::map<std::string, std::string, std::less<>> cells_;
};

Eigen::Vector3d csv_position(const CsvLine& line, const frame::Position& origin) {
  if (!line.has("latitude_deg")) return {line.at("north_m"), line.at("east_m"), line.at("down_m")};
  return frame::ned_offset(origin, {line.at("latitude_deg") * units::degree,
                                    line.at("longitude_deg") * units::degree, line.at("height_m")});
}

std::optional<Pose> csv_pose(const CsvLine& line, const frame::Position& origin) {
  const auto at = line.time();
  if (!at) return {};
  Pose pose{*at, csv_position(line, origin), {}, {}};
  const Eigen::Vector3d angles{line.at("roll_deg"), line.at("pitch_deg"), line.at("heading_deg")};
  const Eigen::Vector3d sigmas{line.at("north_sigma_m"), line.at("east_sigma_m"),
                               line.at("down_sigma_m")};
  if (angles.allFinite())
    pose.body_to_ned = frame::body_to_ned(
        {angles.x() * units::degree, angles.y() * units::degree, angles.z() * units::degree});
  if (sigmas.allFinite()) pose.covariance_m2 = sigmas.cwiseAbs2().asDiagonal();
  return pose;
}

std::string misfit_of_columns(const std::vector<std::string>& names) {
  const std::set<std::string> all(names.begin(), names.end());
  const auto has = [&](std::initializer_list<const char*> wanted) {
    return std::ranges::all_of(wanted, [&](const char* name) { return all.contains(name); });
  };
  if (!has({"t_s"}) && !has({"valid_at_ns"})) return "no column t_s or valid_at_ns";
  if (has({"latitude_deg", "longitude_deg", "height_m"}) || has({"north_m", "east_m", "down_m"}))
    return {};
  return "no columns latitude_deg, longitude_deg, height_m, or north_m, east_m, down_m";
}

}  // namespace

boost::system::result<Track, Problem> read_csv(std::istream& in, const std::string& name,
                                               const frame::Position& origin) {
  std::string text;
  std::getline(in, text);
  const auto names = cells_of(text);
  if (const auto wrong = misfit_of_columns(names); !wrong.empty())
    return Problem{fmt::format("{}:1: {}", name, wrong)};
  Track track;
  for (int number = 2; std::getline(in, text); ++number) {
    if (text.empty() || text == "\r") continue;
    const auto pose = csv_pose(CsvLine(names, cells_of(text)), origin);
    if (!pose || !pose->position_ned.allFinite())
      return Problem{fmt::format("{}:{}: a time or a position is no number", name, number)};
    track.push_back(*pose);
  }
  return track;
}

}  // namespace drydock::score
