#include "hil/world/sensor.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "drivers/measurement/units.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/report/plot.hpp"
#include "hil/sensor/allan.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "rig_config/load.hpp"

namespace drydock::world {
namespace {

constexpr double usual_imu_rate_hz = 100;

rig_config::Axes deviations(const Eigen::Vector3d& variance, double unit) {
  const Eigen::Vector3d deviation = variance.cwiseSqrt() / unit;
  return {deviation.x(), deviation.y(), deviation.z()};
}

void print_allan(const std::vector<AllanRow>& rows, std::FILE* out) {
  fmt::print(out,
             "Allan deviation of a unit level and at rest\n\n"
             "               gyro [deg/h]                       accelerometer [ug]\n"
             "   tau [s]           x          y          z           x          y          z  "
             "clusters\n");
  for (const AllanRow& row : rows) {
    const auto &g = row.gyro_degph, &a = row.accelerometer_ug;
    fmt::print(out, "{:10.2f}  {:10.4g} {:10.4g} {:10.4g}  {:10.4g} {:10.4g} {:10.4g}  {:8}\n",
               row.tau_s, g[0], g[1], g[2], a[0], a[1], a[2], row.clusters);
  }
}

nlohmann::ordered_json allan_json(const std::vector<AllanRow>& rows) {
  auto json = nlohmann::ordered_json::array();
  for (const AllanRow& row : rows)
    json.push_back({{"tau_s", row.tau_s},
                    {"clusters", row.clusters},
                    {"gyro_degph", row.gyro_degph},
                    {"accelerometer_ug", row.accelerometer_ug}});
  return json;
}

std::string allan_svg(const SensorOptions& options, const std::vector<AllanRow>& rows) {
  report::Figure plot{
      "Allan deviation, " + options.grade, "tau [s]", "gyro [deg/h], accelerometer [ug]", {}};
  plot.log_x = plot.log_y = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    report::Curve gyro{fmt::format("gyro {}", "xyz"[axis]), {}, {}},
        accelerometer{fmt::format("accelerometer {}", "xyz"[axis]), {}, {}};
    for (const AllanRow& row : rows) {
      gyro.x.push_back(row.tau_s);
      gyro.y.push_back(row.gyro_degph[axis]);
      accelerometer.x.push_back(row.tau_s);
      accelerometer.y.push_back(row.accelerometer_ug[axis]);
    }
    plot.curves.push_back(std::move(gyro));
    plot.curves.push_back(std::move(accelerometer));
  }
  return report::render_svg(plot);
}

}  // namespace

std::vector<AllanRow> allan_of(const rig_config::EmulateConfig& grade, double rate_hz,
                               double duration_s, std::uint64_t seed) {
  sensor::ImuErrors errors(grade, rate_hz, seed, "bench");
  measurement::ImuSample ideal;
  ideal.angular_rate = Eigen::Vector3d::Zero();
  ideal.specific_force = {0, 0, -units::standard_gravity};
  sensor::AllanVariance gyro, accelerometer;
  const auto samples = static_cast<std::uint64_t>(duration_s * rate_hz);
  for (std::uint64_t k = 0; k < samples; ++k) {
    const double time_s = static_cast<double>(k) / rate_hz;
    ideal.origin.valid_at = measurement::Stamp{measurement::from_seconds(time_s)};
    const auto reading = errors.apply(ideal);
    gyro.add(reading.angular_rate);
    accelerometer.add(reading.specific_force - ideal.specific_force);
  }
  std::vector<AllanRow> rows;
  const auto of_accelerometer = accelerometer.points();
  for (const auto& point : gyro.points())
    rows.push_back({static_cast<double>(point.samples) / rate_hz, point.clusters,
                    deviations(point.variance, units::degree_per_hour),
                    deviations(of_accelerometer[rows.size()].variance, units::micro_g)});
  return rows;
}

int show_sensor(const SensorOptions& options, std::FILE* out, std::FILE* errors) {
  const auto grade = rig_config::load_sensor(options.grade, rig_config::DeviceKind::imu);
  if (!grade) {
    for (const auto& problem : grade.error()) fmt::print(errors, "{}\n", to_string(problem));
    return terminal::exit_usage;
  }
  const double rate_hz = options.rate_hz.value_or(grade->rate_hz.value_or(usual_imu_rate_hz));
  const auto rows = allan_of(*grade, rate_hz, options.duration_s, options.seed);
  if (!options.allan.empty()) {
    const std::string svg = allan_svg(options, rows);
    std::ofstream file(options.allan);
    if (svg.empty() || !(file << svg) || !file.flush()) {
      fmt::print(errors, "drydock sensor: {}: cannot be written{}\n", options.allan,
                 svg.empty() ? ", gnuplot is needed" : "");
      return terminal::exit_failed;
    }
  }
  if (options.json)
    fmt::print(out, "{}\n", text::json_of_any_text(allan_json(rows)));
  else
    print_allan(rows, out);
  return terminal::exit_success;
}

}  // namespace drydock::world
