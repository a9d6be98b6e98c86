#include "hil/motion/splined/pose_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::motion {
namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);
/// A faster turn between two lines is no motion that the lines tell.
constexpr double widest_turn_rad = 90 * units::degree;

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto comma = line.find(',');
    auto cell = line.substr(0, comma);
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    cells.push_back(cell);
    if (comma == line.npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

class PoseReader {
 public:
  PoseReader(const std::string& file, const frame::Position& origin)
      : file_(file), origin_(origin) {}

  void take(std::string_view line) {
    ++number_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (number_ == 1) return take_names(line);
    if (line.empty()) return;
    cells_ = cells_of(line);
    Pose pose{at(time_), position(), attitude()};
    if (poses_.empty()) first_s_ = pose.t_s;
    pose.t_s -= first_s_;
    if (!poses_.empty()) fits_behind(poses_.back(), pose);
    poses_.push_back(pose);
  }

  Poses made() {
    if (poses_.size() < 2) fail("fewer than two lines with a pose, allowed: two or more");
    return std::move(poses_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw BadPoses(fmt::format("{}:{}: {}", file_, std::max(number_, 1), what));
  }

  std::size_t column(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    return found == names_.end() ? no_column : static_cast<std::size_t>(found - names_.begin());
  }

  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> columns(
      const std::array<std::string_view, N>& wanted) const {
    std::array<std::size_t, N> found{};
    for (std::size_t i = 0; i < N; ++i) {
      found[i] = column(wanted[i]);
      if (found[i] == no_column) return {};
    }
    return found;
  }

  void take_names(std::string_view line) {
    for (const auto cell : cells_of(line)) names_.emplace_back(cell);
    time_ = column("time_s");
    if (time_ == no_column) fail("no column time_s");
    using Three = std::array<std::string_view, 3>;
    height_ = columns(Three{"latitude_deg", "longitude_deg", "height_m"});
    depth_ = columns(Three{"latitude_deg", "longitude_deg", "depth_m"});
    offset_ = columns(Three{"north_m", "east_m", "down_m"});
    if (!height_ && !depth_ && !offset_)
      fail(
          "no position, allowed: latitude_deg, longitude_deg and height_m or depth_m; or north_m, "
          "east_m, down_m");
    angles_ = columns(Three{"roll_deg", "pitch_deg", "heading_deg"});
    quaternion_ = columns(std::array<std::string_view, 4>{"qw", "qx", "qy", "qz"});
    if (!angles_ && !quaternion_)
      fail("no attitude, allowed: roll_deg, pitch_deg, heading_deg; or qw, qx, qy, qz");
  }

  double at(std::size_t column) const {
    if (column >= cells_.size())
      fail(fmt::format("{} columns, the first line has {}", cells_.size(), names_.size()));
    const auto cell = cells_[column];
    double value = 0;
    const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || rest != cell.data() + cell.size() || !std::isfinite(value))
      fail(fmt::format("{}: \"{}\" is no number", names_[column], cell.substr(0, 24)));
    return value;
  }

  frame::Position position() const {
    if (!height_ && !depth_)
      return frame::at_ned_offset(origin_,
                                  {at((*offset_)[0]), at((*offset_)[1]), at((*offset_)[2])});
    const auto& place = height_ ? *height_ : *depth_;
    const double latitude = at(place[0]), longitude = at(place[1]);
    if (std::abs(latitude) >= 90 || std::abs(longitude) > 360)
      fail(
          fmt::format("{}, {} is no place, allowed: latitudes between -90 and 90, longitudes -360 "
                      "to 360",
                      latitude, longitude));
    return {latitude * units::degree, longitude * units::degree,
            height_ ? at(place[2]) : -at(place[2])};
  }

  Eigen::Quaterniond attitude() const {
    if (!quaternion_)
      return frame::body_to_ned({at((*angles_)[0]) * units::degree,
                                 at((*angles_)[1]) * units::degree,
                                 at((*angles_)[2]) * units::degree});
    const Eigen::Quaterniond q{at((*quaternion_)[0]), at((*quaternion_)[1]), at((*quaternion_)[2]),
                               at((*quaternion_)[3])};
    if (std::abs(q.norm() - 1) > 0.01)
      fail(fmt::format("the quaternion has the length {:.3f}, allowed: 1", q.norm()));
    return q.normalized();
  }

  void fits_behind(const Pose& before, const Pose& pose) const {
    if (!(pose.t_s > before.t_s))
      fail("time_s is not later than the line before, allowed: rising times");
    const double turn = before.body_to_ned.angularDistance(pose.body_to_ned);
    if (turn > widest_turn_rad)
      fail(fmt::format("turns by {:.0f} deg since the line before, allowed: 90; give more lines",
                       turn * units::degrees_per_radian));
  }

  const std::string& file_;
  frame::Position origin_;
  int number_ = 0;
  double first_s_ = 0;
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;
  std::size_t time_ = no_column;
  std::optional<std::array<std::size_t, 3>> height_, depth_, offset_, angles_;
  std::optional<std::array<std::size_t, 4>> quaternion_;
  Poses poses_;
};

}  // namespace

Poses parse_poses(std::string_view text, const std::string& file, const frame::Position& origin) {
  PoseReader reader(file, origin);
  while (!text.empty()) {
    const auto end = text.find('\n');
    reader.take(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return reader.made();
}

Poses read_poses(const std::string& file, const frame::Position& origin) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadPoses(file + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return parse_poses(text, file, origin);
}

}  // namespace drydock::motion
