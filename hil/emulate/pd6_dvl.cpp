#include "drivers/wire/pd6.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl_head.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

/// The ten lines of an ensemble a sample; the water layer is never found. A Water Linked head sends
/// forward, starboard, down in :BI, has no compass and fills :TS, :BI, :BS and :BD alone.
class Pd6Dvl final : public SamplingDevice {
 public:
  explicit Pd6Dvl(const DeviceSetup& setup)
      : SamplingDevice(setup),
        errors_(setup.primary_errors()),
        water_linked_(setup.config.maker == rig_config::DvlMaker::water_linked) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto truth = trajectory().at(at);
    const auto measured = sensor::ideal_dvl(truth, mounting());
    size_ = 0;
    write_sensors(at, measured, sensor::depth_at(truth, mounting()));
    write(wire::Pd6Velocity<'W', 'I'>{});
    write(wire::Pd6Velocity<'W', 'S'>{});
    write(wire::Pd6Velocity<'W', 'E'>{});
    write(wire::Pd6Distance<'W'>{});
    write_bottom_track(measured);
    out.send(wire::Bytes{bytes_}.first(size_));
  }

  void write_sensors(Stamp at, const measurement::BottomVelocity& measured, double depth_m) {
    wire::Pd6Attitude attitude;
    if (!water_linked_) static_cast<wire::DvlAttitude&>(attitude) = head_attitude(measured);
    write(attitude);
    wire::Pd6Timing timing;
    timing.clock = std::chrono::local_time<std::chrono::milliseconds>{
        std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch())};
    timing.sound_speed_mps = dvl_sound_speed_mps;
    if (!water_linked_) {
      timing.salinity_ppt = dvl_salinity_ppt;
      timing.temperature_k = sensor::water_temperature_k;
      timing.depth_m = std::max(depth_m, 0.0);
    }
    write(timing);
  }

  void write_bottom_track(const measurement::BottomVelocity& measured) {
    wire::Pd6BottomInstrument instrument;
    wire::Pd6BottomShip ship;
    wire::Pd6BottomEarth earth;
    since_good_s_ += 1 / rate_hz();
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      const double error = *measured.error_velocity_mps;
      const Eigen::Vector3d ned =
          frame::body_to_ned({*measured.roll_rad, *measured.pitch_rad, *measured.heading_rad}) * v;
      instrument = {true, along_head_axes(v, error)};
      ship = {true, along_head_axes(v, error)};
      earth = {true, {ned.y(), ned.x(), -ned.z(), {}}};
      if (water_linked_) {
        instrument.velocity_mps = {v.x(), v.y(), v.z(), error};
        ship.velocity_mps = {v.y(), v.x(), v.z(), {}};
        earth = {};
      }
      made_good_ned_ += ned / rate_hz();
      since_good_s_ = 0;
    }
    write(instrument);
    write(ship);
    write(earth);
    wire::Pd6BottomDistance distance;
    if (!water_linked_) {
      distance.distance_m = {made_good_ned_.y(), made_good_ned_.x(), -made_good_ned_.z()};
    }
    distance.range_m = measured.altitude_m;
    distance.since_good_s = water_linked_ ? 0 : std::min(since_good_s_, longest_shown_s);
    write(distance);
  }

  void write(const wire::Pd6::Message& line) {
    size_ += wire::encode(line, std::span{bytes_}.subspan(size_));
  }

  static constexpr double longest_shown_s = 999.99;

  sensor::ErrorModel errors_;
  bool water_linked_;
  Eigen::Vector3d made_good_ned_ = Eigen::Vector3d::Zero();
  double since_good_s_ = 0;
  std::array<std::uint8_t, 10 * wire::Pd6::max_frame> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace

DevicePtr make_pd6_dvl(const DeviceSetup& setup) { return std::make_unique<Pd6Dvl>(setup); }

}  // namespace drydock::emulate
