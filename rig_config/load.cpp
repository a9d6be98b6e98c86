#include "rig_config/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "rig_config/checks/checks.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "rig_config/kinematic_vehicle.hpp"
#include "rig_config/steering.hpp"
#include "rig_config/toml/checked_file.hpp"
#include "rig_config/toml/first_table.hpp"
#include "rig_config/toml/toml_reader.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

/// The mission of a checked document, with the content of its vehicle file.
Loaded<MissionConfig> build_with_vehicle(const Node& root, const std::string& path) {
  MissionConfig mission = build_mission(root, path);
  if (const Node* reference = root.find("mission")->find("vehicle")) {
    const auto vehicle = read_checked_file(beside(path, reference->text), FileKind::vehicle);
    if (!vehicle) return vehicle.error();
    if (has_thrusters(*vehicle)) {
      mission.thruster_vehicle = build_thruster_vehicle(*vehicle);
    } else {
      mission.vehicle = build_vehicle(*vehicle);
    }
    mission.files.push_back(beside(path, reference->text));
  } else if (mission.steering) {
    mission.vehicle = kinematic_vehicle();
  }
  if (auto problems = check_steering(root, path, mission); !problems.empty()) return problems;
  return mission;
}

Loaded<MissionConfig> read_mission(const std::string& path) {
  const auto root = read_checked_file(path, FileKind::mission);
  return root ? build_with_vehicle(*root, path) : Loaded<MissionConfig>(root.error());
}

/// Reads the sensor file of the emulated sensor, then the keys of the device, which override it.
Problems read_emulated_errors(const Node& table, std::size_t index, DeviceConfig& device,
                              const std::string& file) {
  const Node* emulate = table.find("emulate");
  if (!emulate) return {};
  EmulateConfig& emulated = device.emulate;
  if (const Node* errors = emulate->find("errors")) {
    const std::string path = beside(file, errors->text);
    const auto sensors = read_checked_file(path, FileKind::sensor);
    if (!sensors) return sensors.error();
    const Node* grade = sensors->find(to_string(device.kind));
    if (!grade)
      return {{file, errors->at.line, errors->at.column,
               fmt::format("/device/{}/emulate/errors", index), no_table(path, device.kind)}};
    read_errors(*grade, device.kind, emulated);
  }
  read_errors(*emulate, device.kind, emulated);
  if (emulated.rate_hz && !table.find("rate_hz")) device.rate_hz = *emulated.rate_hz;
  if (emulated.power_noise && emulated.sky && !emulate->find("sky")->find("power_noise"))
    emulated.sky->power_noise = *emulated.power_noise;
  return {};
}

/// Kinds of estimators whose blocks name no files take this one.
template <class Kind>
Problems read_kind_files(const EstimatorBlock&, const Kind&) {
  return {};
}

Problems read_estimator_files(const EstimatorBlock& block, EstimatorConfig& estimator) {
  return std::visit([&](auto& kind) { return read_kind_files(block, kind); }, estimator.kind);
}

/// The rig file, then the files that it and its mission name, each once.
std::vector<std::string> files_of(const Node& root, const std::string& path,
                                  const MissionConfig& mission) {
  std::vector<std::string> files{path};
  const auto add = [&](const std::string& file) {
    if (std::ranges::find(files, file) == files.end()) files.push_back(file);
  };
  const auto add_named = [&](const Node* table, const char* key) {
    if (const Node* reference = table ? table->find(key) : nullptr)
      add(beside(path, reference->text));
  };
  add_named(root.find("rig"), "mission");
  for_each_table(root, "device", [&](const Node& table, std::size_t) {
    const std::string description = beside(path, table.find("protocol")->text);
    if (is_description(description) && std::filesystem::exists(description)) add(description);
  });
  for (const auto& file : mission.files) add(file);
  for_each_table(root, "device", [&](const Node& table, std::size_t) {
    add_named(table.find("emulate"), "errors");
  });
  for_each_table(root, "estimator", [&](const Node& table, std::size_t) {
    add_named(&table, "sensors");
    add_named(&table, "vehicle");
  });
  return files;
}

/// The DBC file that a device's description read, if it is not of the program.
void add_dbc_of(const DeviceConfig& device, std::vector<std::string>& files) {
  if (!device.description || device.description->dbc_file.empty()) return;
  if (std::ranges::find(files, device.description->dbc_file) == files.end())
    files.push_back(device.description->dbc_file);
}

}  // namespace

Loaded<Rig> load_rig_text(std::string_view text, const std::string& path,
                          const LoadOptions& options) {
  const auto root = read_checked(text, path, FileKind::rig, options);
  if (!root) return root.error();
  Rig rig = build_rig(*root, path);
  for (DeviceConfig& device : rig.devices)
    if (is_description(device.protocol))
      device.description = find_description(device.protocol, path).value();
  if (auto unheard = check_polled_lines(*root, path, rig.devices); !unheard.empty()) return unheard;
  if (options.devices_only) return rig;
  Problems problems;
  if (const Node* reference = root->find("rig")->find("mission")) {
    const auto mission = read_mission(beside(path, reference->text));
    if (mission) {
      rig.mission = *mission;
      append(problems, check_drives(*root, path, rig));
    } else {
      append(problems, mission.error());
    }
  }
  for_each_table(*root, "device", [&](const Node& table, std::size_t i) {
    append(problems, read_emulated_errors(table, i, rig.devices[i], path));
  });
  for_each_table(*root, "estimator", [&](const Node& table, std::size_t i) {
    append(problems, read_estimator_files({table, i, path}, rig.estimators[i]));
  });
  append(rig.faults, rig.mission.faults);
  append(problems, check_faults_of(rig));
  if (!problems.empty()) return problems;
  rig.files = files_of(*root, path, rig.mission);
  for (const DeviceConfig& device : rig.devices) add_dbc_of(device, rig.files);
  return rig;
}

Loaded<Rig> load_rig(const std::string& path, const LoadOptions& options) {
  const auto text = read_file(path);
  return text ? load_rig_text(*text, path, options) : Loaded<Rig>(text.error());
}

Loaded<MissionConfig> load_mission_text(std::string_view text, const std::string& path) {
  const auto root = read_checked(text, path, FileKind::mission);
  return root ? build_with_vehicle(*root, path) : Loaded<MissionConfig>(root.error());
}

Loaded<MissionConfig> load_mission(const std::string& path) {
  const auto text = read_file(path);
  return text ? load_mission_text(*text, path) : Loaded<MissionConfig>(text.error());
}

Loaded<EmulateConfig> load_sensor(const std::string& path, DeviceKind kind) {
  const auto text = read_file(path);
  return text ? load_sensor_text(*text, path, kind) : Loaded<EmulateConfig>(text.error());
}

Loaded<EmulateConfig> load_sensor_text(std::string_view text, const std::string& path,
                                       DeviceKind kind) {
  const auto root = read_checked(text, path, FileKind::sensor);
  if (!root) return root.error();
  const Node* table = root->find(to_string(kind));
  if (!table) return Problems{{path, 1, 1, "/", no_table(path, kind)}};
  EmulateConfig sensor;
  read_errors(*table, kind, sensor);
  return sensor;
}

Loaded<std::vector<FaultConfig>> load_faults_text(std::string_view text, const std::string& path) {
  const auto root = read_checked(text, path, FileKind::fault);
  if (!root) return root.error();
  return build_faults(*root, path);
}

Loaded<std::vector<FaultConfig>> load_faults(const std::string& path) {
  const auto text = read_file(path);
  return text ? load_faults_text(*text, path) : Loaded<std::vector<FaultConfig>>(text.error());
}

Loaded<VehicleConfig> load_vehicle_text(std::string_view text, const std::string& path) {
  const auto root = read_checked(text, path, FileKind::vehicle);
  if (!root) return root.error();
  if (auto problems = fins_are_missing(*root, path); !problems.empty()) return problems;
  return build_vehicle(*root);
}

Loaded<VehicleConfig> load_vehicle(const std::string& path) {
  const auto text = read_file(path);
  return text ? load_vehicle_text(*text, path) : Loaded<VehicleConfig>(text.error());
}

namespace {

/// Without its first table a file would be taken for one of another kind.
Problems first_table_missing(const Node& root, const std::string& path) {
  for (const auto& [blocks, table] : {std::pair{"device", "rig"}, std::pair{"leg", "mission"}})
    if (root.find(blocks) && !root.find(table))
      return {without_first_table(
          root, path, table,
          fmt::format("a file with blocks [[{}]] has a table [{}] too, and here is none", blocks,
                      table))};
  return {};
}

}  // namespace

Problems check_file(const std::string& path, const LoadOptions& options) {
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto root = read_toml(*text, path);
  if (!root) return root.error();
  if (auto missing = first_table_missing(*root, path); !missing.empty()) return missing;
  const FileKind kind = kind_of(*root);
  if (kind == FileKind::rig) {
    const auto rig = load_rig_text(*text, path, options);
    return rig ? Problems{} : rig.error();
  }
  if (kind == FileKind::mission) {
    const auto mission = load_mission_text(*text, path);
    return mission ? Problems{} : mission.error();
  }
  if (kind == FileKind::device) {
    const auto description = load_description_text(*text, path);
    return description ? Problems{} : description.error();
  }
  const auto document = read_checked(*text, path, kind);
  return document ? Problems{} : document.error();
}

}  // namespace drydock::rig_config
