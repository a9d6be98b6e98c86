#pragma once

#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/measurement/kind.hpp"
#include "drivers/measurement/measurement.hpp"

/// The data on the bus, as the rest of the program sees them. See docs/build/bus.md for the topics.
namespace drydock::bus {

using measurement::Kind;
using measurement::Measurement;
using measurement::Provenance;
using measurement::Stamp;

/// Which messages a subscriber takes for a device. `complete`: Drydock's own message where a
/// standard message would lose a field. `standard`: only messages of ROS 2, for a device that a ROS
/// 2 node drives.
enum class Form : std::uint8_t { complete, standard };

/// One device of the rig. Its index in the list is `Origin::device`.
struct Device {
  std::string name;
  Kind kind = Kind::imu;
  /// For a publisher: every subscriber learns it at discovery, and it is fixed for the publisher's
  /// life. For a subscriber: the value to assume for a writer that declares nothing, such as a ROS
  /// 2 node.
  Provenance provenance = Provenance::real;
  Form form = Form::complete;  ///< for subscribers only: a publisher always writes both
};

/// Attitude relative to NED from an estimator: `rt/estimate/<name>`.
struct Attitude {
  Stamp valid_at{};
  double roll_rad = 0, pitch_rad = 0;
  std::optional<double> yaw_rad;                         ///< clockwise from north, seen from above
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< rad2, roll and pitch
};

/// Position, velocity and attitude from an estimator: nav_msgs/Odometry on
/// `rt/estimate/<name>/odometry`, sensor_msgs/NavSatFix on `rt/estimate/<name>/fix`.
struct Navigation {
  Stamp valid_at{};
  double latitude_rad = 0, longitude_rad = 0, height_m = 0;  ///< WGS-84, height is up
  Eigen::Vector3d offset_ned = Eigen::Vector3d::Zero();      ///< m, from the first estimate
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();    ///< m/s over ground
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
  /// NED: position m, velocity m/s, rotation rad.
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
};

/// What an estimate promises. An error exceeds a bound with a probability of 1e-7 while the
/// estimate is valid and its sensors are sound: docs/estimators/integrity.md. The bus tells it on
/// `rt/diagnostics`.
struct Integrity {
  bool valid = true;
  double roll_bound_rad = 0, pitch_bound_rad = 0;
  std::optional<double> heading_bound_rad, horizontal_bound_m;  ///< empty if not estimated
};

enum class Level : std::uint8_t { ok, warn, error, stale };

/// Compares one measurement with the estimator's prediction of it:
/// `/drydock/<estimator>/innovation/<device>`. docs/use/live.md names the rows. `value` is measured
/// minus expected; `sigma` is its standard deviation.
struct Innovation {
  struct Row {
    double value = 0, sigma = 0;
    bool used = false;
  };
  Stamp valid_at{};
  std::uint16_t estimator = 0, device = 0;
  boost::container::static_vector<Row, 3> rows;
};

/// A pair of estimator and device that gives innovations.
struct InnovationSource {
  std::uint16_t estimator = 0, device = 0;
};

/// A fault that somebody made on purpose, on `/drydock/faults`.
struct Fault {
  std::string device;  ///< empty: the fault is not of one device
  std::string name;    ///< a word of docs/use/faults.md: "hang", "flip"
  std::string text;    ///< words for a person: "dvl: hang"
  Stamp since{};
  std::optional<Stamp> until;  ///< may be in the past or planned; empty: not known

  bool in_force(Stamp now) const { return since <= now && (!until || now < *until); }
};

/// Health of one device: one status in the diagnostic_msgs/DiagnosticArray on `rt/diagnostics`.
struct DeviceStatus {
  Level level = Level::ok;
  std::string name, message, hardware_id;
  std::vector<std::pair<std::string, std::string>> values;
};

}  // namespace drydock::bus
