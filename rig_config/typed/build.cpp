#include "rig_config/typed/build.hpp"

#include <algorithm>
#include <filesystem>
#include <span>

#include "drivers/measurement/sound_speed.hpp"
#include "drivers/measurement/units.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/places_of.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

namespace {

/// Makes the path of a recording relative to the rig file, so that the program finds it from any
/// working directory.
std::string resolved(const std::string& link, const std::string& rig_file) {
  constexpr std::string_view scheme = "file:";
  if (!link.starts_with(scheme)) return link;
  const std::size_t query = std::min(link.find('?'), link.size());
  const std::filesystem::path target = link.substr(scheme.size(), query - scheme.size());
  const auto full = std::filesystem::path(rig_file).parent_path() / target;
  return std::string(scheme) + short_name(full).string() + link.substr(query);
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
  config.mounting_rotation_rad = read_if(table, "mounting_rotation_deg", units::degree);
  read(table, "old_sentences", config.old_sentences);
  read(table, "range_mode", config.range_mode);
  config.acoustic_enabled = read_bool_if(table, "acoustic_enabled");
  config.periodic_cycling = read_bool_if(table, "periodic_cycling");
  return config;
}

UbloxConfig build_ublox(const Node& table) {
  UbloxConfig config;
  config.rate_hz = read_if(table, "rate_hz");
  if (const Node* messages = table.find("messages")) {
    for (const Node::Member& member : messages->members)
      config.messages.push_back({member.key, static_cast<int>(member.value.integer)});
  }
  return config;
}

SoundSpeedConfig build_sound_speed(const Node& table) {
  SoundSpeedConfig config;
  read(table, "source", config.source);
  read(table, "equation", config.equation);
  read(table, "mps", config.mps);
  config.salinity_ppt = read_if(table, "salinity_ppt");
  if (const auto celsius = read_if(table, "temperature_c"))
    config.temperature_k = *celsius + measurement::melting_point_k;
  config.depth_m = read_if(table, "depth_m");
  config.set_mps = read_if(table, "set_mps");
  return config;
}

DeviceConfig build_device(const Node& table, const std::string& rig_file) {
  DeviceConfig device;
  device.line = table.at.line;
  read(table, "name", device.name);
  device.kind = measurement::kind_of(table.find("kind")->text).value();
  read(table, "protocol", device.protocol);
  read(table, "link", device.link);
  device.link = resolved(device.link, rig_file);
  read(table, "rate_hz", device.rate_hz);
  read(table, "stale_after_s", device.stale_after_s);
  read(table, "reopen_after_s", device.reopen_after_s);
  read(table, "latency_ms", device.latency_s, millisecond);
  read(table, "lever_arm_m", device.lever_arm_m);
  read(table, "mounting_deg", device.mounting_rad, units::degree);
  read(table, "address", device.address);
  if (const Node* instance = table.find("instance"))
    device.instance = static_cast<int>(instance->integer);
  read(table, "heartbeat_timeout_s", device.heartbeat_timeout_s);
  read(table, "sync", device.sync);
  read(table, "surface_pressure_pa", device.surface_pressure_pa);
  read(table, "water_density_kgm3", device.water_density_kgm3);
  if (const Node* latitude = table.find("latitude_deg")) {
    device.unesco_latitude_rad = latitude->number * units::degree;
  }
  if (const Node* output = table.find("output")) device.means = output->text == "mean";
  if (const Node* aceinna = table.find("aceinna")) device.aceinna = build_aceinna(*aceinna);
  if (const Node* xsens = table.find("xsens")) device.xsens = build_xsens(*xsens);
  if (const Node* pressure = table.find("pressure")) device.pressure = build_pressure(*pressure);
  std::string maker;
  read(table, "maker", maker);
  if (maker == "water-linked") device.maker = DvlMaker::water_linked;
  device.velocity_sigma_mps = read_if(table, "velocity_sigma_mps", 1);
  read(table, "speed_scale", device.speed_scale);
  read(table, "compass_error_deg", device.compass_error_rad, units::degree);
  device.beam_angle_rad = read_if(table, "beam_angle_deg", units::degree);
  device.levelled = read_bool_if(table, "levelled");
  if (const Node* whose = table.find("velocity_of")) device.velocity_of_bed = whose->text == "bed";
  if (const Node* sound_speed = table.find("sound_speed"))
    device.sound_speed = build_sound_speed(*sound_speed);
  if (const Node* water_linked = table.find("water_linked")) {
    device.water_linked = build_water_linked(*water_linked);
  }
  if (const Node* ublox = table.find("ublox")) device.ublox = build_ublox(*ublox);
  if (const Node* emulate = table.find("emulate")) {
    device.emulate = build_emulate(*emulate, rig_file);
  }
  return device;
}

EstimatorConfig build_estimator(const Node& table) {
  EstimatorConfig estimator;
  read(table, "name", estimator.name);
  read(table, "imu", estimator.imu);
  estimator.kind = read_estimator_kind(table);
  return estimator;
}

}  // namespace

Rig build_rig(const Node& root, const std::string& file) {
  Rig rig;
  rig.file = file;
  rig.places = places_of(root, file);
  const Node& table = *root.find("rig");
  read(table, "name", rig.name);
  if (const Node* seed = table.find("seed")) rig.seed = static_cast<std::uint64_t>(seed->integer);
  if (const Node* start = table.find("start")) rig.start_utc_ns = start->integer;
  read(table, "dds_domain", rig.dds_domain);
  read(table, "dds_interface", rig.dds_interface);
  read(table, "publish", rig.publish);
  read(table, "truth", rig.truth);
  read(table, "reorder_window_s", rig.reorder_window_s);
  for_each_table(root, "device", [&](const Node& device, std::size_t) {
    rig.devices.push_back(build_device(device, file));
  });
  for_each_table(root, "estimator", [&](const Node& estimator, std::size_t) {
    rig.estimators.push_back(build_estimator(estimator));
  });
  rig.expects = build_expects(root);
  rig.faults = build_faults(root, file);
  return rig;
}

}  // namespace drydock::rig_config
