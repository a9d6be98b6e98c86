#include "hil/emulate/described/make_described.hpp"

#include "drivers/measurement/water_column.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/emulate/attitude_readings.hpp"
#include "hil/emulate/described/described_device.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"
#include "hil/emulate/log_readings.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

using wire::described::Readings;
using wire::described::Target;
using enum wire::described::Target;

constexpr double echo_range_m = 200;
constexpr sensor::JanusHead usual_head{.longest_range_m = 100};

void set(Readings& readings, Target first, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i)
    readings.set(static_cast<Target>(static_cast<int>(first) + i), vector[i]);
}

void set_quaternion(Readings& readings, Target scalar, const Eigen::Quaterniond& turned) {
  readings.set(scalar, turned.w());
  set(readings, static_cast<Target>(static_cast<int>(scalar) + 1), turned.vec());
}

class DescribedDepth final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedDepth(const DeviceSetup& setup)
      : DescribedDevice(setup),
        errors_(setup.primary_errors()),
        water_{setup.config.surface_pressure_pa, setup.config.water_density_kgm3,
               setup.config.unesco_latitude_rad} {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto truth = trajectory().at(at);
    const auto ideal = sensor::ideal_depth(truth, trajectory().ocean(), mounting());
    const double pressure_pa = errors_.apply(*ideal.pressure_pa, at);
    readings.set(pressure, pressure_pa);
    readings.set(sea_pressure, pressure_pa - trajectory().ocean().surface_pressure_pa());
    readings.set(depth, water_.depth_m(pressure_pa));
    readings.set(temperature, ideal.temperature_k);
    const double height = sensor::altitude_at(truth, trajectory().ocean(), mounting());
    if (height > 0 && height <= echo_range_m) readings.set(altitude, height);
  }

  sensor::ErrorModel errors_;
  measurement::WaterColumn water_;  ///< of the rig: the sensor was set up with its figures
};

class DescribedDvl final : public DescribedDevice<DvlDevice> {
 public:
  explicit DescribedDvl(const DeviceSetup& setup)
      : DescribedDevice(setup, usual_head), errors_(setup.primary_errors()) {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto ping = this->ping(at);
    if (!ping.velocity) return;
    set(readings, forward, errors_.apply(*ping.velocity, ping.origin.valid_at));
    readings.set(error_velocity, ping.error_velocity_mps);
    readings.set(altitude, ping.altitude_m);
    for (int beam = 0; beam < 4; ++beam)
      readings.set(static_cast<Target>(static_cast<int>(range_1) + beam),
                   ping.range_m[static_cast<std::size_t>(beam)]);
    readings.set(heading, ping.heading_rad);
    readings.set(pitch, ping.pitch_rad);
    readings.set(roll, ping.roll_rad);
    readings.set(sound_speed, ping.sound_speed);
  }

  sensor::ErrorModel errors_;
};

class DescribedEmLog final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedEmLog(const DeviceSetup& setup) : DescribedDevice(setup), readings_(setup) {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto speed = readings_.at(trajectory(), at, mounting(), rate_hz());
    readings.set(longitudinal, speed.x());
    readings.set(transverse, speed.y());
    readings.set(distance, readings_.distance_m());
  }

  LogReadings readings_;
};

class DescribedImu final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedImu(const DeviceSetup& setup)
      : DescribedDevice(setup), ideal_(setup.imu_sampler()), errors_(setup.imu_errors()) {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto measured = errors_.apply(ideal_.at(at));
    set(readings, force_x, measured.specific_force);
    set(readings, rate_x, measured.angular_rate);
  }

  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

class DescribedGnss final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedGnss(const DeviceSetup& setup) : DescribedDevice(setup), receiver_(setup) {
    sample_at_whole_multiples();
  }

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto fix = receiver_.measure(trajectory().at(at), mounting()).fix;
    if (fix.utc) readings.set(utc, measurement::seconds(fix.utc->time_since_epoch()));
    if (!fix.position || !fix.velocity_ned) return;
    readings.set(latitude, fix.position->latitude_rad);
    readings.set(longitude, fix.position->longitude_rad);
    readings.set(ellipsoidal_height, fix.ellipsoidal_height_m);
    readings.set(sea_level_height, fix.mean_sea_level_height_m);
    readings.set(north, fix.velocity_ned->x());
    readings.set(east, fix.velocity_ned->y());
    readings.set(down, fix.velocity_ned->z());
    readings.set(ground_speed, fix.velocity_ned->head<2>().norm());
    readings.set(course, course_rad(*fix.velocity_ned));
    readings.set(horizontal_accuracy, fix.horizontal_accuracy_m);
    readings.set(vertical_accuracy, fix.vertical_accuracy_m);
    readings.set(speed_accuracy, fix.speed_accuracy_mps);
    readings.set(dilution, fix.position_dop);
    if (fix.satellites_used) readings.set(satellites_used, *fix.satellites_used);
  }

  GnssSensor receiver_;
};

class DescribedActuators final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedActuators(const DeviceSetup& setup)
      : DescribedDevice(setup),
        angle_errors_(setup.primary_errors()),
        shaft_errors_(setup.secondary_errors()) {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto ideal = sensor::ideal_actuators(trajectory().at(at));
    set(readings, rudder,
        angle_errors_.apply(
            Eigen::Vector3d(*ideal.rudder_rad, *ideal.stern_plane_rad, *ideal.bow_plane_rad), at));
    readings.set(propeller, shaft_errors_.apply(*ideal.propeller_radps, at));
  }

  sensor::ErrorModel angle_errors_, shaft_errors_;
};

/// A description that reads the reference of its heading gets that of the rig; another one gets the
/// true heading and the magnetic one.
class DescribedCompass final : public DescribedDevice<SamplingDevice> {
 public:
  explicit DescribedCompass(const DeviceSetup& setup)
      : DescribedDevice(setup),
        readings_(setup),
        tells_reference_(std::ranges::any_of(
            setup.config.description->plan.fields,
            [](const auto& field) { return field.target == heading_reference; })) {}

 private:
  void measure(Stamp at, Readings& readings) override {
    const auto sample = readings_.at(trajectory().at(at), mounting());
    const bool magnetic = sample.reference == measurement::HeadingReference::magnetic_north;
    readings.set(heading, tells_reference_ ? sample.heading_rad : sample.true_heading_rad);
    readings.set(heading_reference, tells_reference_ && magnetic ? 1 : 0);
    readings.set(magnetic_heading, AttitudeReadings::in_circle(*sample.true_heading_rad -
                                                               sample.variation_rad.value_or(0)));
    readings.set(deviation, sample.deviation_rad);
    readings.set(variation, sample.variation_rad);
    readings.set(roll, sample.roll_rad);
    readings.set(pitch, sample.pitch_rad);
    readings.set(rate_of_turn, sample.rate_of_turn_radps);
    set_quaternions(readings);
  }

  /// Of the angles that the sensor says, its errors included.
  static void set_quaternions(Readings& readings) {
    const Eigen::Quaterniond ned =
        frame::body_to_ned({*readings.get(roll), *readings.get(pitch), *readings.get(heading)});
    const Eigen::Matrix3d swap_and_flip{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    const Eigen::Matrix3d starboard_to_port = Eigen::Vector3d(1, -1, -1).asDiagonal();
    set_quaternion(readings, quaternion_w, ned);
    set_quaternion(readings, enu_quaternion_w,
                   Eigen::Quaterniond(Eigen::Matrix3d(swap_and_flip * ned.toRotationMatrix() *
                                                      starboard_to_port)));
  }

  AttitudeReadings readings_;
  bool tells_reference_;
};

}  // namespace

std::unique_ptr<EmulatedDevice> make_described(const DeviceSetup& setup) {
  using rig_config::DeviceKind;
  switch (setup.config.kind) {
    case DeviceKind::depth: return std::make_unique<DescribedDepth>(setup);
    case DeviceKind::dvl: return std::make_unique<DescribedDvl>(setup);
    case DeviceKind::emlog: return std::make_unique<DescribedEmLog>(setup);
    case DeviceKind::gnss: return std::make_unique<DescribedGnss>(setup);
    case DeviceKind::actuator: return std::make_unique<DescribedActuators>(setup);
    case DeviceKind::attitude: return std::make_unique<DescribedCompass>(setup);
    case DeviceKind::imu: break;
  }
  return std::make_unique<DescribedImu>(setup);
}

}  // namespace drydock::emulate
