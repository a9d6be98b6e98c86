#pragma once

#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/measurement/measurement.hpp"

/// What travels on the bus, as the rest of the program sees it. See docs/build/bus.md for the
/// topics.
namespace drydock::bus {

using measurement::Measurement;
using measurement::Provenance;
using measurement::Stamp;

enum class Kind : std::uint8_t { dvl, emlog, gnss, imu, depth, actuator };

/// Which messages a subscriber takes for a device. `complete`: Drydock's own where a standard one
/// would lose a field. `standard`: only ROS 2's, for a device that a ROS 2 node drives.
enum class Form : std::uint8_t { complete, standard };

/// One device of the rig; its place in the list is `Origin::device`.
struct Device {
  std::string name;
  Kind kind = Kind::imu;
  /// Publishing: declared to every subscriber at discovery, and fixed for the publisher's life.
  /// Subscribing: what to assume of a writer that declares nothing, such as a ROS 2 node.
  Provenance provenance = Provenance::real;
  Form form = Form::complete;  ///< subscribing only; a publisher always writes both
};

/// Attitude against NED as an estimator gives it: `rt/estimate/<name>`.
struct Attitude {
  Stamp valid_at{};
  double roll_rad = 0, pitch_rad = 0;
  std::optional<double> yaw_rad;                         ///< from north, clockwise seen from above
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< rad2, roll and pitch
};

/// Position, velocity and attitude as an estimator gives them: nav_msgs/Odometry on
/// `rt/estimate/<name>/odometry`, sensor_msgs/NavSatFix on `rt/estimate/<name>/fix`.
struct Navigation {
  Stamp valid_at{};
  double latitude_rad = 0, longitude_rad = 0, height_m = 0;  ///< WGS-84, up
  Eigen::Vector3d offset_ned = Eigen::Vector3d::Zero();      ///< m, from the first estimate
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();    ///< m/s over ground
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
  /// NED: position m, velocity m/s, rotation rad.
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
};

enum class Level : std::uint8_t { ok, warn, error, stale };

/// One measurement against what an estimator expected of it: `/drydock/<estimator>/innovation/
/// <device>`. Rows as docs/use/live.md names them: measured minus expected, and its sigma.
struct Innovation {
  struct Row {
    double value = 0, sigma = 0;
    bool used = false;
  };
  Stamp valid_at{};
  std::uint16_t estimator = 0, device = 0;
  boost::container::static_vector<Row, 3> rows;
};

/// Whose innovations there will be.
struct InnovationSource {
  std::uint16_t estimator = 0, device = 0;
};

/// A fault made on purpose, on `/drydock/faults`.
struct Fault {
  std::string device;  ///< empty: none alone
  std::string name;    ///< in the vocabulary of faults: "bit-errors"
  std::string text;    ///< for a person: "one bit in 10000 is wrong"
  Stamp since{};
  std::optional<Stamp> until;  ///< past or planned; empty: not known

  bool in_force(Stamp now) const { return since <= now && (!until || now < *until); }
};

/// Health of one device: one status of the diagnostic_msgs/DiagnosticArray on `rt/diagnostics`.
struct DeviceStatus {
  Level level = Level::ok;
  std::string name, message, hardware_id;
  std::vector<std::pair<std::string, std::string>> values;
};

}  // namespace drydock::bus
