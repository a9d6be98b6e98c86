#include "rig_config/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "rig_config/build.hpp"
#include "rig_config/checks.hpp"
#include "rig_config/schema_check.hpp"
#include "rig_config/toml_limits.hpp"
#include "rig_config/toml_reader.hpp"

namespace drydock::rig_config {

namespace {

namespace fs = std::filesystem;

enum class FileKind : std::uint8_t { rig, mission, sensor, vehicle };

std::string_view described(FileKind kind) {
  if (kind == FileKind::rig) return "a rig file, which has a table [rig]";
  if (kind == FileKind::mission) return "a mission file, which has a table [mission]";
  if (kind == FileKind::vehicle) return "a vehicle file, which has a table [vehicle]";
  return "a sensor file, which has a table for each kind of sensor: [imu], [dvl], ...";
}

FileKind kind_of(const Node& root) {
  if (root.find("rig")) return FileKind::rig;
  if (root.find("vehicle")) return FileKind::vehicle;
  return root.find("mission") ? FileKind::mission : FileKind::sensor;
}

Loaded<std::string> read_file(const std::string& path) {
  // A device or a pipe may never end, and a file may be larger than the memory.
  std::error_code error;
  std::ifstream in;
  if (fs::is_regular_file(path, error)) in.open(path, std::ios::binary);
  const auto size = fs::file_size(path, error);
  if (in.is_open() && size > largest_file)
    return Problems{
        {path, 0, 0, "/", fmt::format("has {} bytes, allowed: up to {}", size, largest_file)}};
  std::ostringstream text;
  if (!in.is_open() || !(text << in.rdbuf()))
    return Problems{{path, 0, 0, "/", "cannot be read: it is missing, empty or not a file"}};
  return std::move(text).str();
}

void append(Problems& to, Problems more) { std::ranges::move(more, std::back_inserter(to)); }

void sort_by_position(Problems& problems) {
  std::ranges::stable_sort(problems, [](const Problem& a, const Problem& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
}

/// What the caller finds wrong with a link says more than the schema's pattern, which sees only the
/// scheme.
void keep_one_for_each_link(Problems& of_schema, const Problems& of_rig) {
  std::erase_if(of_schema, [&](const Problem& p) {
    return p.path.ends_with("/link") &&
           std::ranges::any_of(of_rig, [&](const Problem& q) { return q.path == p.path; });
  });
}

/// A document that the schema and the checks of its kind have nothing against.
Loaded<Node> read_checked(std::string_view text, const std::string& path, FileKind kind,
                          const LoadOptions& options = {}) {
  Loaded<Node> root = read_toml(text, path);
  if (!root) return root;
  if (kind_of(*root) != kind)
    return Problems{{path, 1, 1, "/", fmt::format("expected {}", described(kind))}};
  Problems problems =
      check_schema(*root, path, kind == FileKind::vehicle ? vehicle_schema_text() : schema_text());
  if (kind == FileKind::rig) {
    Problems of_rig = check_rig(*root, path, options);
    keep_one_for_each_link(problems, of_rig);
    append(problems, std::move(of_rig));
  }
  if (kind == FileKind::mission) append(problems, check_mission(*root, path));
  sort_by_position(problems);
  if (!problems.empty()) return problems;
  return root;
}

Loaded<Node> read_checked_file(const std::string& path, FileKind kind) {
  const auto text = read_file(path);
  return text ? read_checked(*text, path, kind) : Loaded<Node>(text.error());
}

/// The mission of a checked document with its vehicle file read in.
Loaded<MissionConfig> build_with_vehicle(const Node& root, const std::string& path) {
  MissionConfig mission = build_mission(root, path);
  if (const Node* reference = root.find("mission")->find("vehicle")) {
    const auto vehicle = read_checked_file(beside(path, reference->text), FileKind::vehicle);
    if (!vehicle) return vehicle.error();
    mission.vehicle = build_vehicle(*vehicle);
    mission.files.push_back(beside(path, reference->text));
  }
  return mission;
}

Loaded<MissionConfig> read_mission(const std::string& path) {
  const auto root = read_checked_file(path, FileKind::mission);
  return root ? build_with_vehicle(*root, path) : Loaded<MissionConfig>(root.error());
}

std::string no_table(const std::string& path, DeviceKind kind) {
  return fmt::format("{} has no table [{}]", path, name_of(kind));
}

/// What the sensor file says of the emulated sensor, then the device's own keys on top.
Problems read_emulated_errors(const Node& table, std::size_t index, DeviceConfig& device,
                              const std::string& file) {
  const Node* emulate = table.find("emulate");
  if (!emulate) return {};
  EmulateConfig& emulated = device.emulate;
  if (const Node* errors = emulate->find("errors")) {
    const std::string path = beside(file, errors->text);
    const auto sensors = read_checked_file(path, FileKind::sensor);
    if (!sensors) return sensors.error();
    const Node* grade = sensors->find(name_of(device.kind));
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

/// What the sensor file of an inertial navigation says of those of its sensors that it names.
Problems read_grades(const Node& table, std::size_t index, InertialConfig& inertial,
                     const std::string& file) {
  const Node* reference = table.find("sensors");
  if (!reference) return {};
  const std::string path = beside(file, reference->text);
  const auto sensors = read_checked_file(path, FileKind::sensor);
  if (!sensors) return sensors.error();
  struct Wanted {
    const char* key;
    DeviceKind kind;
    EmulateConfig InertialConfig::*grade;
  };
  Problems problems;
  for (const auto& [key, kind, grade] :
       {Wanted{"imu", DeviceKind::imu, &InertialConfig::imu_grade},
        Wanted{"dvl", DeviceKind::dvl, &InertialConfig::dvl_grade},
        Wanted{"log", DeviceKind::emlog, &InertialConfig::log_grade},
        Wanted{"depth", DeviceKind::depth, &InertialConfig::depth_grade}}) {
    if (!table.find(key)) continue;
    if (const Node* found = sensors->find(name_of(kind))) {
      read_errors(*found, kind, inertial.*grade);
    } else {
      problems.push_back({file, reference->at.line, reference->at.column,
                          fmt::format("/estimator/{}/sensors", index), no_table(path, kind)});
    }
  }
  return problems;
}

Problems read_estimator_files(const Node& table, std::size_t index, EstimatorConfig& estimator,
                              const std::string& file) {
  Problems problems = read_grades(table, index, estimator.inertial, file);
  if (const Node* reference = table.find("vehicle")) {
    const auto vehicle = read_checked_file(beside(file, reference->text), FileKind::vehicle);
    if (!vehicle) {
      append(problems, vehicle.error());
    } else {
      estimator.inertial.vehicle = build_vehicle(*vehicle);
    }
  }
  return problems;
}

/// Its own file, then those that it and its mission name, each once.
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

}  // namespace

Loaded<Rig> load_rig_text(std::string_view text, const std::string& path,
                          const LoadOptions& options) {
  const auto root = read_checked(text, path, FileKind::rig, options);
  if (!root) return root.error();
  Rig rig = build_rig(*root, path);
  if (options.devices_only) return rig;
  Problems problems;
  if (const Node* reference = root->find("rig")->find("mission")) {
    const auto mission = read_mission(beside(path, reference->text));
    if (mission)
      rig.mission = *mission;
    else
      append(problems, mission.error());
  }
  for_each_table(*root, "device", [&](const Node& table, std::size_t i) {
    append(problems, read_emulated_errors(table, i, rig.devices[i], path));
  });
  for_each_table(*root, "estimator", [&](const Node& table, std::size_t i) {
    append(problems, read_estimator_files(table, i, rig.estimators[i], path));
  });
  if (!problems.empty()) return problems;
  rig.files = files_of(*root, path, rig.mission);
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
  const Node* table = root->find(name_of(kind));
  if (!table) return Problems{{path, 1, 1, "/", no_table(path, kind)}};
  EmulateConfig sensor;
  read_errors(*table, kind, sensor);
  return sensor;
}

Loaded<VehicleConfig> load_vehicle_text(std::string_view text, const std::string& path) {
  const auto root = read_checked(text, path, FileKind::vehicle);
  if (!root) return root.error();
  return build_vehicle(*root);
}

Loaded<VehicleConfig> load_vehicle(const std::string& path) {
  const auto text = read_file(path);
  return text ? load_vehicle_text(*text, path) : Loaded<VehicleConfig>(text.error());
}

Problems check_file(const std::string& path, const LoadOptions& options) {
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto root = read_toml(*text, path);
  if (!root) return root.error();
  const FileKind kind = kind_of(*root);
  if (kind == FileKind::rig) {
    const auto rig = load_rig_text(*text, path, options);
    return rig ? Problems{} : rig.error();
  }
  if (kind == FileKind::mission) {
    const auto mission = load_mission_text(*text, path);
    return mission ? Problems{} : mission.error();
  }
  const auto document = read_checked(*text, path, kind);
  return document ? Problems{} : document.error();
}

}  // namespace drydock::rig_config
