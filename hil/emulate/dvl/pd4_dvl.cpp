#include "drivers/wire/dvl/pd4.hpp"

#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/dvl_head.hpp"
#include "hil/emulate/dvl/rdi_dvl.hpp"

namespace drydock::emulate {
namespace {

/// One PD4 or PD5 report per sample, in ship axes without tilts, which are the head's own. A Water
/// Linked head reports "ship axes with tilts" and sends forward, starboard, down, as its maker
/// documents.
template <class Protocol>
class Pd4Dvl final : public RdiDvl {
 public:
  explicit Pd4Dvl(const DeviceSetup& setup)
      : RdiDvl(setup, std::is_same_v<Protocol, wire::Pd5> ? 5 : 4),
        errors_(setup.primary_errors()),
        water_linked_(setup.config.maker == rig_config::DvlMaker::water_linked) {}

 private:
  using Report = typename Protocol::Report;

  void sample(Stamp at, Wire& out) override {
    const auto measured = ping(at);
    if (!pings(at)) return;
    Report report;
    report.frame = wire::DvlFrame::ship;
    report.tilts_used = water_linked_;
    report.three_beam = !water_linked_ && head().fewest_beams == 3;
    report.frequency_hz = 600e3;
    set_bottom_track(measured, report);
    set_water_track(measured, report);
    const auto clock = device_time(at).time_since_epoch();
    const auto since_midnight = clock - std::chrono::floor<std::chrono::days>(clock);
    report.first_ping = std::chrono::duration_cast<std::chrono::milliseconds>(since_midnight);
    report.sound_speed_mps = measured.sound_speed;
    report.temperature_k = trajectory().ocean().temperature_k();
    if constexpr (std::is_same_v<Protocol, wire::Pd5>) {
      static_cast<wire::DvlAttitude&>(report) = head_attitude(measured);
      report.salinity_ppt = trajectory().ocean().salinity_ppt();
      report.depth_m = std::max(measured.depth_m, 0.0);
    }
    out.send(wire::Bytes{bytes_}.first(wire::encode(report, bytes_)));
  }

  void set_bottom_track(const sensor::DvlPing& measured, Report& report) {
    report.bottom_range_m = measured.range_m;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!measured.range_m[i]) report.bottom_status |= static_cast<std::uint8_t>(2u << 2 * i);
    }
    if (!measured.velocity) return;
    const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
    report.bottom_velocity_mps = in_report_axes(v, measured.error_velocity_mps);
  }

  void set_water_track(const sensor::DvlPing& measured, Report& report) const {
    const auto& water = measured.water;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!water.beam_good[i]) report.water_status |= static_cast<std::uint8_t>(3u << 2 * i);
    }
    if (head().layer) {
      report.layer_start_m = head().layer->start_m;
      report.layer_end_m = head().layer->start_m + head().layer->thickness_m;
    }
    if (water.velocity)
      report.water_velocity_mps = in_report_axes(*water.velocity, water.error_velocity_mps);
  }

  wire::DvlComponents in_report_axes(const Eigen::Vector3d& v, std::optional<double> error) const {
    if (water_linked_) return {v.x(), v.y(), v.z(), error};
    return along_head_axes(v, error);
  }

  sensor::ErrorModel errors_;
  bool water_linked_;
  std::array<std::uint8_t, Protocol::max_frame> bytes_{};
};

}  // namespace

DevicePtr make_pd4_dvl(const DeviceSetup& setup) {
  return std::make_unique<Pd4Dvl<wire::Pd4>>(setup);
}

DevicePtr make_pd5_dvl(const DeviceSetup& setup) {
  return std::make_unique<Pd4Dvl<wire::Pd5>>(setup);
}

}  // namespace drydock::emulate
