#include "tests/estimators/navigation/recordings/drive_recording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <sstream>

#include "tests/estimators/navigation/recordings/polled_imu.hpp"

namespace drydock::navigation::test {

static_assert(std::endian::native == std::endian::little);  // the tags are little-endian

namespace {

constexpr double in_radians = std::numbers::pi / 180, standard_gravity = 9.80665;
constexpr double day = 86400;
constexpr double logger_loop_s = 2.048e-3;  // polls occur at its turns; the rows have only whole ms
constexpr std::size_t tag_header = 64;      // then time_t and fraction of a second, then pairs

Read<std::filesystem::path> only_file(const std::filesystem::path& folder, const std::string& end) {
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator{folder, error})
    if (entry.path().filename().string().ends_with(end)) found.push_back(entry.path());
  if (found.size() == 1) return found.front();
  return Refusal{folder, std::to_string(found.size()) + " files *" + end + ", expected one"};
}

Read<std::vector<RtkFix>> read_solution(const std::filesystem::path& file) {
  const Read<std::string> text = read_text(file);
  if (text.has_error()) return text.error();
  std::istringstream lines{*text};
  std::vector<RtkFix> fixes;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (line.starts_with('%')) continue;
    int hour = 0, minute = 0;
    double second = 0, v[22];
    std::istringstream fields{line};
    std::string date, time;
    fields >> date >> time;
    if (std::sscanf(time.c_str(), "%d:%d:%lf", &hour, &minute, &second) != 3)
      return Refusal{file, number, "no time: " + time};
    for (double& value : v)
      if (!(fields >> value)) return Refusal{file, number, "expected 22 numbers after the time"};
    double t = hour * 3600 + minute * 60 + second;
    if (!fixes.empty() && t < fixes.back().t - day / 2) t += day;
    if (!fixes.empty() && t <= fixes.back().t) return Refusal{file, number, "time runs backwards"};
    if (!(std::abs(v[0]) < 90 && std::abs(v[1]) <= 180))
      return Refusal{file, number, "no such place"};
    if (!(v[5] > 0 && v[6] > 0 && v[7] > 0)) return Refusal{file, number, "deviation not positive"};
    fixes.push_back({t,
                     {v[0] * in_radians, v[1] * in_radians, v[2]},
                     static_cast<int>(v[3]),
                     {v[5], v[6], v[7]},
                     {v[13], v[14], -v[15]}});
  }
  if (fixes.empty()) return Refusal{file, "holds no fix"};
  return fixes;
}

struct Line {
  double origin, offset, slope;
  double at(double x) const { return offset + slope * (x - origin); }
};

/// The logger's time of day as a line over the IMU's clock.
Read<Line> read_clock(const std::filesystem::path& tags, const std::string& csv,
                      const std::vector<std::vector<double>>& rows) {
  const Read<std::string> text = read_text(tags);
  if (text.has_error()) return text.error();
  const std::string& bytes = *text;
  std::uint32_t start = 0, pair[2];
  double fraction = 0;
  constexpr std::size_t first = tag_header + sizeof start + sizeof fraction;
  if (!bytes.starts_with("TIMETAG") || bytes.size() < first + 2 * sizeof pair)
    return Refusal{tags, "not a file of RTKLIB time tags"};
  std::memcpy(&start, bytes.data() + tag_header, sizeof start);
  std::memcpy(&fraction, bytes.data() + tag_header + sizeof start, sizeof fraction);
  // Tags count the logged bytes. A file with converted line ends is shorter.
  const std::size_t last = first + (bytes.size() - first) / sizeof pair * sizeof pair - sizeof pair;
  std::memcpy(pair, bytes.data() + last, sizeof pair);
  const std::size_t lost = pair[1] > csv.size() ? 1 : 0;
  std::vector<std::size_t> ends;
  for (std::size_t at = csv.find('\n'); at != std::string::npos; at = csv.find('\n', at + 1))
    ends.push_back(at + 1 + lost * (ends.size() + 1));

  std::vector<Eigen::Vector2d> points;
  for (std::size_t at = first; at <= last; at += sizeof pair) {
    std::memcpy(pair, bytes.data() + at, sizeof pair);
    const auto after = std::upper_bound(ends.begin(), ends.end(), pair[1]);
    const auto row = static_cast<std::size_t>(after - ends.begin());
    if (row > 0 && row <= rows.size()) points.emplace_back(rows[row - 1][6] * 1e-3, pair[0] * 1e-3);
  }
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  double xx = 0, xy = 0;
  for (const auto& point : points) {
    xx += std::pow(point.x() - mean.x(), 2);
    xy += (point.x() - mean.x()) * (point.y() - mean.y());
  }
  if (!(xx > 0)) return Refusal{tags, "no two tags that belong to lines of the recording"};
  return Line{mean.x(), std::fmod(start, day) + fraction + mean.y(), xy / xx};
}

/// The times of the rows by the IMU's count. They are finer than its ms if they fit the turns of
/// the logger's loop.
std::vector<Poll> read_polls(const std::vector<std::vector<double>>& rows) {
  std::complex<double> turn = 0;
  const auto angle = [](double t) { return 2 * std::numbers::pi * t / logger_loop_s; };
  for (const auto& row : rows) turn += std::polar(1.0, angle(row[6] * 1e-3));
  const bool on_turns = std::abs(turn) > 0.5 * static_cast<double>(rows.size());
  const double first = std::arg(turn) / (2 * std::numbers::pi) * logger_loop_s;
  std::vector<Poll> polls;
  for (const auto& row : rows) {
    double t = row[6] * 1e-3;
    if (on_turns) t = first + std::round((t - first) / logger_loop_s) * logger_loop_s;
    polls.push_back({t, Eigen::Map<const Vector6>(row.data())});
  }
  return polls;
}

}  // namespace

Read<DriveRecording> read_drive(const std::filesystem::path& folder) {
  const auto solution = only_file(folder, ".pos"), imu = only_file(folder, ".csv"),
             tags = only_file(folder, ".csv.tag");
  for (const auto* file : {&solution, &imu, &tags})
    if (file->has_error()) return file->error();
  auto fixes = read_solution(*solution);
  if (fixes.has_error()) return fixes.error();
  const auto rows = read_csv(*imu, 7, 6);
  if (rows.has_error()) return rows.error();
  const auto text = read_text(*imu);
  if (text.has_error()) return text.error();
  const auto clock = read_clock(*tags, *text, *rows);
  if (clock.has_error()) return clock.error();

  const auto own = own_samples(read_polls(*rows));
  if (own.has_error()) return Refusal{*imu, own.error().line};

  DriveRecording drive{{},       std::move(*fixes), clock->slope, own->period_s, own->repeated,
                       own->lost};
  for (const OwnSample& sample : own->samples)
    drive.imu.push_back({clock->at(sample.t), sample.value.tail<3>() * in_radians,
                         sample.value.head<3>() * standard_gravity,
                         sample.missed.tail<3>() * in_radians,
                         sample.missed.head<3>() * standard_gravity});
  return drive;
}

}  // namespace drydock::navigation::test
