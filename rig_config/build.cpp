#include "rig_config/build.hpp"

#include <algorithm>
#include <filesystem>
#include <span>

#include "rig_config/checks.hpp"
#include "rig_config/read_keys.hpp"

namespace drydock::rig_config {

namespace {

constexpr double degree_per_hour = degree / 3600;
constexpr double millisecond = 1e-3;
constexpr double milli_g = 9.80665e-3, micro_g = 9.80665e-6;  // standard gravity, ISO 80000-3

/// The schema holds the same names in the order of the enumeration.
template <class Enum, std::size_t N>
Enum named(const Node& table, const std::array<const char*, N>& names) {
  const auto found = std::ranges::find(names, table.find("kind")->text);
  return static_cast<Enum>(found - names.begin());
}

constexpr std::array device_kinds{"dvl", "emlog", "gnss", "imu", "depth", "actuator"};
constexpr std::array leg_kinds{"straight", "turn", "dive", "s_path"};

struct ErrorKey {
  DeviceKind kind;
  const char* key;
  SensorErrors EmulateConfig::*quantity;
  std::array<double, 3> SensorErrors::*part;
  double unit;
};
using E = EmulateConfig;
using S = SensorErrors;
constexpr ErrorKey error_keys[] = {
    {DeviceKind::dvl, "velocity_bias_mps", &E::primary, &S::bias, 1},
    {DeviceKind::dvl, "velocity_noise_mps", &E::primary, &S::noise, 1},
    {DeviceKind::emlog, "speed_bias_mps", &E::primary, &S::bias, 1},
    {DeviceKind::emlog, "speed_noise_mps", &E::primary, &S::noise, 1},
    {DeviceKind::gnss, "position_noise_m", &E::primary, &S::noise, 1},
    {DeviceKind::gnss, "velocity_noise_mps", &E::secondary, &S::noise, 1},
    {DeviceKind::imu, "gyro_bias_degph", &E::primary, &S::bias, degree_per_hour},
    {DeviceKind::imu, "gyro_noise_degph", &E::primary, &S::noise, degree_per_hour},
    {DeviceKind::imu, "accelerometer_bias_mg", &E::secondary, &S::bias, milli_g},
    {DeviceKind::imu, "accelerometer_noise_ug", &E::secondary, &S::noise, micro_g},
    {DeviceKind::depth, "pressure_bias_pa", &E::primary, &S::bias, 1},
    {DeviceKind::depth, "pressure_noise_pa", &E::primary, &S::noise, 1},
};

/// A recording named relative to the rig file stays found wherever the program is started.
std::string resolved(const std::string& link, const std::string& rig_file) {
  constexpr std::string_view scheme = "file:";
  if (!link.starts_with(scheme)) return link;
  const std::size_t query = std::min(link.find('?'), link.size());
  const std::filesystem::path target = link.substr(scheme.size(), query - scheme.size());
  const auto full = std::filesystem::path(rig_file).parent_path() / target;
  return std::string(scheme) + full.lexically_normal().string() + link.substr(query);
}

AceinnaConfig build_aceinna(const Node& table) {
  AceinnaConfig aceinna;
  read(table, "packet_rate_hz", aceinna.packet_rate_hz);
  read(table, "slope_message", aceinna.slope_message);
  read(table, "rate_filter_hz", aceinna.rate_filter_hz);
  read(table, "acceleration_filter_hz", aceinna.acceleration_filter_hz);
  read(table, "orientation", aceinna.orientation);
  return aceinna;
}

XsensConfig build_xsens(const Node& table) {
  XsensConfig xsens;
  read(table, "extended", xsens.extended);
  if (const Node* identifiers = table.find("identifiers")) {
    for (const Node::Member& member : identifiers->members)
      xsens.identifiers.push_back({member.key, static_cast<std::uint32_t>(member.value.integer)});
  }
  return xsens;
}

PressureConfig build_pressure(const Node& table) {
  PressureConfig pressure;
  read(table, "format", pressure.format);
  read(table, "unit", pressure.unit);
  read(table, "decimals", pressure.decimals);
  std::string reference;
  read(table, "reference", reference);
  pressure.gauge = reference == "gauge";
  return pressure;
}

WaterLinkedConfig build_water_linked(const Node& table) {
  WaterLinkedConfig config;
  config.sound_speed_mps = read_if(table, "sound_speed_mps");
  config.mounting_rotation_rad = read_if(table, "mounting_rotation_deg", degree);
  read(table, "old_sentences", config.old_sentences);
  return config;
}

SkyConfig build_sky(const Node& table, const std::string& rig_file) {
  SkyConfig sky;
  sky.ephemeris = beside(rig_file, table.find("ephemeris")->text);
  if (const Node* at = table.find("at")) sky.at_utc_ns = at->integer;
  if (const Node* axis = table.find("antenna_axis")) {  // "-z": sign, then axis
    sky.antenna_axis = {};
    sky.antenna_axis.at(static_cast<std::size_t>(axis->text[1] - 'x')) =
        axis->text[0] == '-' ? -1 : 1;
  }
  read(table, "boresight_cno_dbhz", sky.boresight_cno_dbhz);
  read(table, "power_noise", sky.power_noise);
  read(table, "lowest_cno_dbhz", sky.lowest_cno_dbhz);
  read(table, "elevation_mask_deg", sky.elevation_mask_rad, degree);
  return sky;
}

DeviceConfig build_device(const Node& table, const std::string& rig_file) {
  DeviceConfig device;
  device.line = table.at.line;
  read(table, "name", device.name);
  device.kind = named<DeviceKind>(table, device_kinds);
  read(table, "protocol", device.protocol);
  read(table, "link", device.link);
  device.link = resolved(device.link, rig_file);
  read(table, "rate_hz", device.rate_hz);
  read(table, "stale_after_s", device.stale_after_s);
  read(table, "reopen_after_s", device.reopen_after_s);
  read(table, "latency_ms", device.latency_s, millisecond);
  read(table, "lever_arm_m", device.lever_arm_m);
  read(table, "mounting_deg", device.mounting_rad, degree);
  read(table, "address", device.address);
  read(table, "heartbeat_timeout_s", device.heartbeat_timeout_s);
  read(table, "sync", device.sync);
  read(table, "surface_pressure_pa", device.surface_pressure_pa);
  read(table, "water_density_kgm3", device.water_density_kgm3);
  if (const Node* latitude = table.find("latitude_deg")) {
    device.unesco_latitude_rad = latitude->number * degree;
  }
  if (const Node* aceinna = table.find("aceinna")) device.aceinna = build_aceinna(*aceinna);
  if (const Node* xsens = table.find("xsens")) device.xsens = build_xsens(*xsens);
  if (const Node* pressure = table.find("pressure")) device.pressure = build_pressure(*pressure);
  std::string maker;
  read(table, "maker", maker);
  if (maker == "water-linked") device.maker = DvlMaker::water_linked;
  device.beam_angle_rad = read_if(table, "beam_angle_deg", degree);
  if (const Node* water_linked = table.find("water_linked")) {
    device.water_linked = build_water_linked(*water_linked);
  }
  if (const Node* emulate = table.find("emulate")) {
    read(*emulate, "fixed_bias", device.emulate.fixed_bias);
    read(*emulate, "latency_ms", device.emulate.latency_s, millisecond);
    if (const Node* sky = emulate->find("sky")) device.emulate.sky = build_sky(*sky, rig_file);
  }
  return device;
}

EstimatorConfig build_estimator(const Node& table) {
  EstimatorConfig estimator;
  read(table, "name", estimator.name);
  read(table, "kind", estimator.kind);
  read(table, "imu", estimator.imu);
  read(table, "log", estimator.log);
  std::string filter, model, start;
  read(table, "filter", filter);
  if (filter == "augmented") estimator.filter = LevelingFilter::augmented;
  if (filter == "paper") estimator.filter = LevelingFilter::paper;
  read(table, "model", model);
  read(table, "start", start);
  estimator.stationary = model == "stationary";
  estimator.accelerometer_start = start != "given";
  read(table, "initial_roll_deg", estimator.initial_roll_rad, degree);
  read(table, "initial_pitch_deg", estimator.initial_pitch_rad, degree);
  read(table, "latitude_deg", estimator.latitude_rad, degree);
  read(table, "heading_deg", estimator.heading_rad, degree);
  return estimator;
}

LegConfig build_leg(const Node& table, double speed_before) {
  LegConfig leg;
  leg.kind = named<LegKind>(table, leg_kinds);
  leg.speed_mps = speed_before;
  read(table, "duration_s", leg.duration_s);
  read(table, "speed_mps", leg.speed_mps);
  read(table, "turn_deg", leg.turn_rad, degree);
  read(table, "roll_deg", leg.roll_rad, degree);
  read(table, "depth_change_m", leg.depth_change_m);
  read(table, "amplitude_deg", leg.amplitude_rad, degree);
  read(table, "period_s", leg.period_s);
  return leg;
}

BallisticConfig build_ballistic(const Node& table) {
  BallisticConfig flight;
  read(table, "height_m", flight.height_m);
  read(table, "ground_height_m", flight.ground_height_m);
  read(table, "elevation_deg", flight.elevation_rad, degree);
  read(table, "ballistic_coefficient_kgm2", flight.ballistic_coefficient_kgm2);
  read(table, "roll_rate_degps", flight.roll_rate_radps, degree);
  read(table, "roll_deg", flight.roll_rad, degree);
  read(table, "spin_up_s", flight.spin_up_s);
  read(table, "angle_of_attack_deg", flight.angle_of_attack_rad, degree);
  read(table, "coning_hz", flight.coning_radps, 2 * std::numbers::pi);
  return flight;
}

}  // namespace

void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into) {
  for (const ErrorKey& error : error_keys)
    if (error.kind == kind) read(table, error.key, into.*error.quantity.*error.part, error.unit);
}

Rig build_rig(const Node& root, const std::string& file) {
  Rig rig;
  rig.file = file;
  const Node& table = *root.find("rig");
  read(table, "name", rig.name);
  if (const Node* seed = table.find("seed")) rig.seed = static_cast<std::uint64_t>(seed->integer);
  if (const Node* start = table.find("start")) rig.start_utc_ns = start->integer;
  read(table, "dds_domain", rig.dds_domain);
  read(table, "publish", rig.publish);
  read(table, "reorder_window_s", rig.reorder_window_s);
  for_each_table(root, "device", [&](const Node& device, std::size_t) {
    rig.devices.push_back(build_device(device, file));
  });
  for_each_table(root, "estimator", [&](const Node& estimator, std::size_t) {
    rig.estimators.push_back(build_estimator(estimator));
  });
  return rig;
}

MissionConfig build_mission(const Node& root) {
  MissionConfig mission;
  const Node& table = *root.find("mission");
  read(table, "latitude_deg", mission.latitude_rad, degree);
  read(table, "longitude_deg", mission.longitude_rad, degree);
  read(table, "depth_m", mission.depth_m);
  read(table, "heading_deg", mission.heading_rad, degree);
  read(table, "speed_mps", mission.speed_mps);
  read(table, "bed_depth_m", mission.bed_depth_m);
  read(table, "current_ned_mps", mission.current_ned_mps);
  double speed_mps = mission.speed_mps;
  for_each_table(root, "leg", [&](const Node& leg, std::size_t) {
    mission.legs.push_back(build_leg(leg, speed_mps));
    speed_mps = mission.legs.back().speed_mps;
  });
  if (const Node* ballistic = root.find("ballistic")) {
    mission.ballistic = build_ballistic(*ballistic);
    read(*ballistic, "speed_mps", mission.speed_mps);
  }
  return mission;
}

}  // namespace drydock::rig_config
