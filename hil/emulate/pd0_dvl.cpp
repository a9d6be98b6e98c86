#include "drivers/wire/pd0.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl_head.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr double frequency_hz = 600e3;

wire::Pd0FixedLeader fixed_leader(const sensor::JanusBeams& beams) {
  wire::Pd0FixedLeader leader;
  leader.firmware_version = 34;
  leader.frequency_hz = frequency_hz;
  leader.beam_angle_rad = beams.angle_rad;
  leader.pings_per_ensemble = 1;
  leader.frame = wire::DvlFrame::ship;
  leader.sensor_source = leader.sensors_available = 0b0111'1101;  // all but a conductivity cell
  return leader;
}

class Pd0Dvl final : public SamplingDevice {
 public:
  explicit Pd0Dvl(const DeviceSetup& setup)
      : SamplingDevice(setup), errors_(setup.primary_errors()) {
    ensemble_.fixed = fixed_leader(beams_);
  }

 private:
  void sample(Stamp at, Wire& out) override {
    const auto truth = trajectory().at(at);
    const auto measured = sensor::ideal_dvl(truth, mounting(), beams_);
    set_variable_leader(measured, sensor::depth_at(truth, mounting()));
    set_bottom_track(measured);
    out.send(wire::Bytes{bytes_}.first(wire::encode(ensemble_, bytes_)));
  }

  void set_variable_leader(const measurement::BottomVelocity& measured, double depth_m) {
    auto& leader = ensemble_.variable;
    leader.ensemble = static_cast<std::uint32_t>(samples() + 1) & 0xFFFFFF;
    leader.clock = std::chrono::local_time<std::chrono::milliseconds>{
        std::chrono::duration_cast<std::chrono::milliseconds>(
            measured.origin.valid_at.time_since_epoch())};
    leader.sound_speed_mps = dvl_sound_speed_mps;
    leader.depth_m = std::max(depth_m, 0.0);
    static_cast<wire::DvlAttitude&>(leader) = head_attitude(measured);
    leader.salinity_ppt = dvl_salinity_ppt;
    leader.temperature_k = sensor::water_temperature_k;
  }

  void set_bottom_track(const measurement::BottomVelocity& measured) {
    wire::Pd0BottomTrack track;
    track.pings_per_ensemble = 1;
    track.max_depth_m = beams_.longest_range_m;
    track.range_m = measured.range_m;
    for (std::size_t i = 0; i < track.range_m.size(); ++i) {
      if (!track.range_m[i]) continue;
      track.correlation[i] = 200;
      track.amplitude[i] = 100;
      track.percent_good[i] = 100;
    }
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      track.velocity_mps = along_head_axes(v, *measured.error_velocity_mps);
    }
    ensemble_.bottom_track = track;
  }

  sensor::JanusBeams beams_;
  sensor::ErrorModel errors_;
  wire::Pd0Ensemble ensemble_;
  std::array<std::uint8_t, 512> bytes_{};
};

}  // namespace

DevicePtr make_pd0_dvl(const DeviceSetup& setup) { return std::make_unique<Pd0Dvl>(setup); }

}  // namespace drydock::emulate
