#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig_config/rig.hpp"
#include "rig_config/vehicle.hpp"

/// Reads rig, mission, sensor and vehicle files (TOML). First it checks each file against a JSON
/// Schema of `rig_config/schema`, which is built into the program. Then it checks what a schema
/// cannot express: names and files must exist. It reports all problems at once.
namespace drydock::rig_config {

/// One mistake in a file; `path` names the key, as in `/device/0/rate_hz`.
struct Problem {
  std::string file;
  int line = 0, column = 0;  ///< from 1; 0 if the file could not be read at all
  std::string path;
  std::string what;  ///< what is wrong, what is allowed

  friend bool operator==(const Problem&, const Problem&) = default;
};

/// `file:line:column: path: what is wrong, what is allowed`
std::string to_string(const Problem& problem);

using Problems = std::vector<Problem>;

/// A problem at this path of a file. If the file does not have the key, the problem stands at the
/// table of the key.
Problem problem_at(const PlacesPtr& places, std::string path, std::string what);

/// Values, or every problem of the file in file order.
template <class T>
using Loaded = boost::system::result<T, Problems>;

/// Makes Loaded::value() throw std::runtime_error with all lines.
[[noreturn]] void throw_exception_from_error(const Problems& problems,
                                             const boost::source_location& where);

struct LoadOptions {
  /// Returns what is wrong with a link URI, or nothing if it is good. This folder must not depend
  /// on the links, so the caller provides the check. Without it any text passes.
  std::function<std::optional<std::string>(std::string_view uri)> link_check;
  /// Reads only what the drivers need, without the mission and the sensor files that the rig names.
  /// A recording contains the rig file, but not always these files.
  bool devices_only = false;
};

/// The rig with the content of its mission and sensor files. `file:` links are relative to the
/// folder of the rig file.
Loaded<Rig> load_rig(const std::string& path, const LoadOptions& options = {});

/// The same from text. Problems name `path`, and relative paths start at its folder.
Loaded<Rig> load_rig_text(std::string_view text, const std::string& path,
                          const LoadOptions& options = {});

Loaded<MissionConfig> load_mission(const std::string& path);
Loaded<MissionConfig> load_mission_text(std::string_view text, const std::string& path);

/// The errors of sensors of a kind from a sensor file. hil/sensor makes error models from them.
Loaded<EmulateConfig> load_sensor(const std::string& path, DeviceKind kind);
Loaded<EmulateConfig> load_sensor_text(std::string_view text, const std::string& path,
                                       DeviceKind kind);

/// The faults of a file of blocks [[fault]], or of such a text from the command line.
/// check_faults_of() checks their devices.
Loaded<std::vector<FaultConfig>> load_faults(const std::string& path);
Loaded<std::vector<FaultConfig>> load_faults_text(std::string_view text, const std::string& path);

/// Problems of faults for unknown devices, and of faults that a device behind this target cannot
/// have.
Problems check_faults_of(const Rig& rig, FaultTarget target = FaultTarget::emulated);

/// Coefficients stay prime values; estimators/vehicle converts them for the equations of motion.
Loaded<VehicleConfig> load_vehicle(const std::string& path);
Loaded<VehicleConfig> load_vehicle_text(std::string_view text, const std::string& path);

/// Problems of a rig, mission, sensor or vehicle file. The top-level tables give the kind of file.
Problems check_file(const std::string& path, const LoadOptions& options = {});

/// The JSON Schema (draft-07) of rig, mission and sensor files, that of vehicle files, and that of
/// descriptions of sensors.
std::string_view schema_text();
std::string_view vehicle_schema_text();
std::string_view device_schema_text();

}  // namespace drydock::rig_config
