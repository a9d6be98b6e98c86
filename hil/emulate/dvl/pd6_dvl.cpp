#include "drivers/wire/dvl/pd6.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/dvl_head.hpp"
#include "hil/emulate/dvl/rdi_dvl.hpp"

namespace drydock::emulate {
namespace {

/// One ensemble of ten lines per sample. A Water Linked head sends forward, starboard, down in :BI,
/// has no compass and fills only :TS, :BI, :BS and :BD.
class Pd6Dvl final : public RdiDvl {
 public:
  explicit Pd6Dvl(const DeviceSetup& setup)
      : RdiDvl(setup, 6),
        errors_(setup.primary_errors()),
        water_linked_(setup.config.maker == rig_config::DvlMaker::water_linked) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = ping(at);
    if (!pings(at)) return;
    size_ = 0;
    write_sensors(at, measured);
    write_water_track(measured);
    write_bottom_track(measured);
    out.send(wire::Bytes{bytes_}.first(size_));
  }

  void write_sensors(Stamp at, const sensor::DvlPing& measured) {
    wire::Pd6Attitude attitude;
    if (!water_linked_) static_cast<wire::DvlAttitude&>(attitude) = head_attitude(measured);
    write(attitude);
    wire::Pd6Timing timing;
    timing.clock = std::chrono::local_time<std::chrono::milliseconds>{
        std::chrono::duration_cast<std::chrono::milliseconds>(device_time(at).time_since_epoch())};
    timing.sound_speed_mps = measured.sound_speed;
    if (!water_linked_) {
      timing.salinity_ppt = trajectory().ocean().salinity_ppt();
      timing.temperature_k = trajectory().ocean().temperature_k();
      timing.depth_m = std::max(measured.depth_m, 0.0);
    }
    write(timing);
  }

  /// Distance made good since boot, and the time since the last good velocity.
  struct Way {
    Eigen::Vector3d ned_m = Eigen::Vector3d::Zero();
    double since_good_s = 0;
  };

  void write_water_track(const sensor::DvlPing& measured) {
    if (!head().layer || water_linked_) {
      write(wire::Pd6Velocity<'W', 'I'>{});
      write(wire::Pd6Velocity<'W', 'S'>{});
      write(wire::Pd6Velocity<'W', 'E'>{});
      return write(wire::Pd6Distance<'W'>{});
    }
    const sensor::WaterLayer& layer = *head().layer;
    write_track<'W'>(measured, measured.water.velocity, measured.water.error_velocity_mps,
                     layer.start_m + layer.thickness_m / 2, through_water_);
  }

  void write_bottom_track(const sensor::DvlPing& measured) {
    std::optional<Eigen::Vector3d> velocity;
    if (measured.velocity) velocity = errors_.apply(*measured.velocity, measured.origin.valid_at);
    write_track<'B'>(measured, velocity, measured.error_velocity_mps, measured.altitude_m,
                     over_bed_);
  }

  template <char Reference>
  void write_track(const sensor::DvlPing& measured, const std::optional<Eigen::Vector3d>& velocity,
                   std::optional<double> error, std::optional<double> range_m, Way& way) {
    wire::Pd6Velocity<Reference, 'I'> instrument;
    wire::Pd6Velocity<Reference, 'S'> ship;
    wire::Pd6Velocity<Reference, 'E'> earth;
    way.since_good_s += 1 / rate_hz();
    if (velocity) {
      const Eigen::Vector3d& v = *velocity;
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
      way.ned_m += ned / rate_hz();
      way.since_good_s = 0;
    }
    write(instrument);
    write(ship);
    write(earth);
    wire::Pd6Distance<Reference> distance;
    if (!water_linked_) distance.distance_m = {way.ned_m.y(), way.ned_m.x(), -way.ned_m.z()};
    distance.range_m = range_m;
    distance.since_good_s = water_linked_ ? 0 : std::min(way.since_good_s, longest_shown_s);
    write(distance);
  }

  void write(const wire::Pd6::Message& line) {
    size_ += wire::encode(line, std::span{bytes_}.subspan(size_));
  }

  static constexpr double longest_shown_s = 999.99;

  sensor::ErrorModel errors_;
  bool water_linked_;
  Way over_bed_, through_water_;
  std::array<std::uint8_t, 10 * wire::Pd6::max_frame> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace

DevicePtr make_pd6_dvl(const DeviceSetup& setup) { return std::make_unique<Pd6Dvl>(setup); }

}  // namespace drydock::emulate
