#include "drivers/measurement/units.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

SkyConfig build_sky(const Node& table, const std::string& rig_file) {
  SkyConfig sky;
  sky.ephemeris = beside(rig_file, table.find("ephemeris")->text);
  if (const Node* at = table.find("at")) sky.at_utc_ns = at->integer;
  read_axis(table, "antenna_axis", sky.antenna_axis);
  read(table, "boresight_cno_dbhz", sky.boresight_cno_dbhz);
  read(table, "power_noise", sky.power_noise);
  read(table, "lowest_cno_dbhz", sky.lowest_cno_dbhz);
  read(table, "elevation_mask_deg", sky.elevation_mask_rad, units::degree);
  return sky;
}

DvlHeadConfig build_head(const Node& table) {
  DvlHeadConfig head;
  head.shortest_range_m = read_if(table, "shortest_range_m");
  head.longest_range_m = read_if(table, "longest_range_m");
  if (const Node* three = table.find("three_beams")) head.three_beams = three->boolean;
  head.sound_speed_mps = read_if(table, "sound_speed_mps");
  read(table, "fading_db", head.fading_db);
  read(table, "beam_noise_mps", head.beam_noise_mps);
  read(table, "layer_start_m", head.layer_start_m);
  read(table, "layer_thickness_m", head.layer_thickness_m);
  return head;
}

CompassConfig build_compass(const Node& table) {
  CompassConfig compass;
  compass.variation_rad = read_if(table, "variation_deg", units::degree);
  std::string reference;
  read(table, "reference", reference);
  compass.magnetic = reference == "magnetic";
  return compass;
}

}  // namespace

EmulateConfig build_emulate(const Node& table, const std::string& rig_file) {
  EmulateConfig emulate;
  if (const Node* sky = table.find("sky")) emulate.sky = build_sky(*sky, rig_file);
  if (const Node* head = table.find("head")) emulate.head = build_head(*head);
  emulate.compass = build_compass(table);
  if (table.find("model"))
    emulate.model = named<UbloxModel>(table, std::array{"m8", "f9"}, "model");
  return emulate;
}

}  // namespace drydock::rig_config
