#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/bus/message_types.hpp"

/// Converts measurements to messages and back.
/// `fill` sets everything but the frame name. It returns false if the message type cannot express
/// the sample. `read` sets everything but received_at, provenance and device. It returns false if
/// the content cannot be such a measurement: an unknown enumerator, or a required value is missing.
namespace drydock::bus {

using namespace measurement;

inline constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

/// This variance, in the unit of its quantity squared, means that the accuracy is not known: the
/// messages of geometry_msgs have no flag for it, and 0 would say that the value is exact.
inline constexpr double unknown_variance = 1e6;

TimeMessage to_time(Stamp stamp);
Stamp to_stamp(const TimeMessage& time);
OptionalTimeMessage to_optional_time(std::optional<std::chrono::nanoseconds> time);
std::optional<std::chrono::nanoseconds> to_nanoseconds(const OptionalTimeMessage& time);
Vector3Message to_vector3(const Eigen::Vector3d& v);
Eigen::Vector3d to_eigen(const Vector3Message& v);
std::optional<Eigen::Vector3d> to_optional(const Vector3Message& v);

inline double or_nan(std::optional<double> value) { return value.value_or(not_available); }
inline std::optional<double> to_optional(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

template <class Matrix>
void put_by_rows(double (&to)[9], const Matrix& matrix) {
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{to} = matrix;
}

/// FRD <-> FLU: a half turn about x. It is exact and its own inverse.
inline Eigen::Vector3d half_turn_about_x(const Eigen::Vector3d& v) {
  return {v.x(), -v.y(), -v.z()};
}
/// NED <-> ENU: exact and its own inverse.
inline Eigen::Vector3d swap_ned_enu(const Eigen::Vector3d& v) { return {v.y(), v.x(), -v.z()}; }

bool fill(ImuMessage& message, const ImuSample& sample);
bool fill(DvlMessage& message, const BottomVelocity& sample);
bool fill(TwistMessage& message, const BottomVelocity& sample);
bool fill(TwistMessage& message, const WaterSpeed& sample);
bool fill(TwistMessage& message, const GnssFix& sample);
bool fill(NavSatFixMessage& message, const GnssFix& sample);
bool fill(FluidPressureMessage& message, const DepthSample& sample);
bool fill(TemperatureMessage& message, const DepthSample& sample);

bool read(ImuSample& sample, const ImuMessage& message);
bool read(BottomVelocity& sample, const DvlMessage& message);
bool read(WaterSpeed& sample, const TwistMessage& message);
bool read(GnssFix& sample, const NavSatFixMessage& message);
bool read(DepthSample& sample, const FluidPressureMessage& message);

bool fill(DepthMessage& message, const DepthSample& sample);
bool fill(BottomTrackMessage& message, const BottomVelocity& sample);
bool fill(WaterSpeedMessage& message, const WaterSpeed& sample);
bool fill(GnssFixMessage& message, const GnssFix& sample);
bool fill(GnssSatellitesMessage& message, const GnssSatellites& sample);
bool fill(ActuatorStateMessage& message, const ActuatorState& sample);
bool fill(AttitudeMessage& message, const AttitudeSample& sample);

bool read(DepthSample& sample, const DepthMessage& message);
bool read(BottomVelocity& sample, const BottomTrackMessage& message);
bool read(WaterSpeed& sample, const WaterSpeedMessage& message);
bool read(GnssFix& sample, const GnssFixMessage& message);
bool read(GnssSatellites& sample, const GnssSatellitesMessage& message);
bool read(ActuatorState& sample, const ActuatorStateMessage& message);
bool read(AttitudeSample& sample, const AttitudeMessage& message);

bool fill(ImuMessage& message, const Attitude& attitude);
bool read(Attitude& attitude, const ImuMessage& message);

/// Pose in the ENU axes of the first estimate, velocity in the body frame (FLU). Angular velocity
/// is not given: its variance is -1.
bool fill(OdometryMessage& message, const Navigation& navigation);
bool fill(NavSatFixMessage& message, const Navigation& navigation);

/// Sets the fields that are constant for a topic: source, axes, unit.
void describe(InnovationMessage& message, const Device& source);
/// Sets the other fields. Allocates nothing.
void fill(InnovationMessage& message, const Innovation& innovation);

/// Treats strings as `fill` for diagnostics below does.
void fill(FaultsMessage& message, std::span<const Fault> faults, Stamp now);
std::vector<Fault> read(const FaultsMessage& message);

/// Replaces everything but the frame name. Cyclone owns the strings (dds_sample_free releases
/// them).
void fill(DiagnosticsMessage& message, std::span<const DeviceStatus> health, Stamp now);
DeviceStatus read(const diagnostic_msgs_msg_dds__DiagnosticStatus_& status);

}  // namespace drydock::bus
