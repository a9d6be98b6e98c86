#include "rig_config/estimator/inertial.hpp"

#include <fmt/format.h>

#include "drivers/measurement/units.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/toml/checked_file.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

InertialConfig read_inertial(const Node& table) {
  InertialConfig inertial;
  read(table, "dvl", inertial.dvl);
  read(table, "depth", inertial.depth);
  read(table, "gate_sigma", inertial.gate_sigma);
  read(table, "sea_level_m", inertial.sea_level_m);
  const Node* initial = table.find("initial");
  if (!initial) return inertial;
  read(*initial, "latitude_deg", inertial.latitude_rad, units::degree);
  read(*initial, "longitude_deg", inertial.longitude_rad, units::degree);
  read(*initial, "depth_m", inertial.depth_m);
  read(*initial, "velocity_ned_mps", inertial.velocity_ned_mps);
  read(*initial, "roll_deg", inertial.roll_rad, units::degree);
  read(*initial, "pitch_deg", inertial.pitch_rad, units::degree);
  read(*initial, "heading_deg", inertial.heading_rad, units::degree);
  read(*initial, "position_sigma_m", inertial.position_sigma_m);
  read(*initial, "depth_sigma_m", inertial.depth_sigma_m);
  read(*initial, "velocity_sigma_mps", inertial.velocity_sigma_mps);
  read(*initial, "tilt_sigma_deg", inertial.tilt_sigma_rad, units::degree);
  read(*initial, "heading_sigma_deg", inertial.heading_sigma_rad, units::degree);
  return inertial;
}

Problems read_grades(const EstimatorBlock& block, std::initializer_list<WantedGrade> wanted) {
  const Node* reference = block.table.find("sensors");
  if (!reference) return {};
  const std::string path = beside(block.file, reference->text);
  const auto sensors = read_checked_file(path, FileKind::sensor);
  if (!sensors) return sensors.error();
  Problems problems;
  for (const WantedGrade& grade : wanted) {
    if (!block.table.find(grade.key)) continue;
    if (const Node* found = sensors->find(to_string(grade.kind))) {
      read_errors(*found, grade.kind, grade.into);
    } else {
      problems.push_back({block.file, reference->at.line, reference->at.column,
                          fmt::format("/estimator/{}/sensors", block.index),
                          no_table(path, grade.kind)});
    }
  }
  return problems;
}

}  // namespace drydock::rig_config
