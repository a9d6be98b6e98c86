#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig_config/rig.hpp"
#include "rig_config/vehicle.hpp"

/// Reads rig, mission, sensor and vehicle files (TOML). Each is checked against a JSON Schema of
/// `rig_config/schema`, which is built into the program, then for what a schema cannot say: names
/// that must exist, files that must be there. All problems are reported at once.
namespace drydock::rig_config {

/// One mistake in a file; `path` names the key, as in `/device/0/rate_hz`.
struct Problem {
  std::string file;
  int line = 0, column = 0;  ///< from 1; 0 where the file could not be read at all
  std::string path;
  std::string what;  ///< what is wrong, what is allowed

  friend bool operator==(const Problem&, const Problem&) = default;
};

/// `file:line:column: path: what is wrong, what is allowed`
std::string to_string(const Problem& problem);

using Problems = std::vector<Problem>;

/// Values, or every problem of the file in file order.
template <class T>
using Loaded = boost::system::result<T, Problems>;

/// Lets Loaded::value() throw std::runtime_error with all lines.
[[noreturn]] void throw_exception_from_error(const Problems& problems,
                                             const boost::source_location& where);

struct LoadOptions {
  /// Says what is wrong with a link URI, nothing if it is good. This folder knows no links, so the
  /// caller brings the knowledge; without it any text passes.
  std::function<std::optional<std::string>(std::string_view uri)> link_check;
  /// Only what the drivers need: the files that a rig names, of missions and of sensors' errors,
  /// are left alone. A recording has the rig file, not always those.
  bool devices_only = false;
};

/// The rig with its mission and sensor files read in and its `file:` links made relative to the
/// rig file's folder.
Loaded<Rig> load_rig(const std::string& path, const LoadOptions& options = {});

/// The same from text; `path` is named in problems and relative files are sought beside it.
Loaded<Rig> load_rig_text(std::string_view text, const std::string& path,
                          const LoadOptions& options = {});

Loaded<MissionConfig> load_mission(const std::string& path);
Loaded<MissionConfig> load_mission_text(std::string_view text, const std::string& path);

/// The grade that a sensor file gives sensors of a kind: what hil/sensor makes error models of.
Loaded<EmulateConfig> load_sensor(const std::string& path, DeviceKind kind);
Loaded<EmulateConfig> load_sensor_text(std::string_view text, const std::string& path,
                                       DeviceKind kind);

/// Faults alone, as a file of blocks [[fault]] or what is typed has them. Their devices are the
/// rig's: check_faults_of().
Loaded<std::vector<FaultConfig>> load_faults(const std::string& path);
Loaded<std::vector<FaultConfig>> load_faults_text(std::string_view text, const std::string& path);

/// Faults of devices that the rig has not, or that its devices cannot have behind such a target.
Problems check_faults_of(const Rig& rig, FaultTarget target = FaultTarget::emulated);

/// Prime values stay prime: estimators/vehicle makes the equations of motion of them.
Loaded<VehicleConfig> load_vehicle(const std::string& path);
Loaded<VehicleConfig> load_vehicle_text(std::string_view text, const std::string& path);

/// Problems of a rig, mission, sensor or vehicle file, told apart by their top-level tables.
Problems check_file(const std::string& path, const LoadOptions& options = {});

/// The JSON Schema (draft-07) of rig, mission and sensor files, and that of vehicle files.
std::string_view schema_text();
std::string_view vehicle_schema_text();

}  // namespace drydock::rig_config
