#include "drivers/wire/dvl/pd0.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/dvl_head.hpp"
#include "hil/emulate/dvl/rdi_dvl.hpp"

namespace drydock::emulate {
namespace {

constexpr double frequency_hz = 600e3;

wire::Pd0FixedLeader fixed_leader(const sensor::JanusHead& head) {
  wire::Pd0FixedLeader leader;
  leader.firmware_version = 34;
  leader.frequency_hz = frequency_hz;
  leader.beam_angle_rad = head.beam_angle_rad;
  leader.pings_per_ensemble = 1;
  leader.frame = wire::DvlFrame::ship;
  leader.three_beam = head.fewest_beams == 3;
  leader.sensor_source = leader.sensors_available = 0b0111'1101;  // all but a conductivity cell
  return leader;
}

class Pd0Dvl final : public RdiDvl {
 public:
  explicit Pd0Dvl(const DeviceSetup& setup) : RdiDvl(setup, 0), errors_(setup.primary_errors()) {
    ensemble_.fixed = fixed_leader(head());
  }

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = ping(at);
    if (!pings(at)) return;
    set_variable_leader(measured);
    set_bottom_track(measured);
    out.send(wire::Bytes{bytes_}.first(wire::encode(ensemble_, bytes_)));
  }

  void set_variable_leader(const sensor::DvlPing& measured) {
    auto& leader = ensemble_.variable;
    leader.ensemble = static_cast<std::uint32_t>(samples() + 1) & 0xFFFFFF;
    leader.clock = std::chrono::local_time<std::chrono::milliseconds>{
        std::chrono::duration_cast<std::chrono::milliseconds>(
            device_time(measured.origin.valid_at).time_since_epoch())};
    leader.sound_speed_mps = measured.sound_speed;
    leader.depth_m = std::max(measured.depth_m, 0.0);
    static_cast<wire::DvlAttitude&>(leader) = head_attitude(measured);
    leader.salinity_ppt = trajectory().ocean().salinity_ppt();
    leader.temperature_k = trajectory().ocean().temperature_k();
  }

  void set_bottom_track(const sensor::DvlPing& measured) {
    wire::Pd0BottomTrack track;
    track.pings_per_ensemble = 1;
    track.max_depth_m = head().longest_range_m;
    track.range_m = measured.range_m;
    for (std::size_t i = 0; i < track.range_m.size(); ++i) {
      if (!track.range_m[i]) continue;
      track.correlation[i] = correlation_counts(measured.beams[i].snr_db);
      track.amplitude[i] = amplitude_counts(measured.beams[i].snr_db);
      track.percent_good[i] = 100;
    }
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      track.velocity_mps = along_head_axes(v, measured.error_velocity_mps);
    }
    if (head().layer) set_water_track(measured.water, track);
    ensemble_.bottom_track = track;
  }

  void set_water_track(const sensor::DvlPing::Water& water, wire::Pd0BottomTrack& track) const {
    track.layer_near_m = head().layer->start_m;
    track.layer_far_m = head().layer->start_m + head().layer->thickness_m;
    for (std::size_t i = 0; i < 4; ++i) track.water_percent_good[i] = water.beam_good[i] ? 100 : 0;
    if (water.velocity)
      track.water_velocity_mps = along_head_axes(*water.velocity, water.error_velocity_mps);
  }

  sensor::ErrorModel errors_;
  wire::Pd0Ensemble ensemble_;
  std::array<std::uint8_t, 512> bytes_{};
};

}  // namespace

DevicePtr make_pd0_dvl(const DeviceSetup& setup) { return std::make_unique<Pd0Dvl>(setup); }

}  // namespace drydock::emulate
