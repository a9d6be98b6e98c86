#include <cmath>

#include "drivers/wire/ubx/ubx.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"

namespace drydock::emulate {
namespace {

wire::NavPvt nav_pvt(const GnssEpoch& epoch) {
  wire::NavPvt pvt;
  pvt.itow = epoch.time_of_week;
  if (epoch.time_is_known) {
    pvt.date = epoch.date;
    pvt.time_of_day = epoch.time_of_day;
  }
  pvt.time_resolved = epoch.time_is_known;
  const auto& fix = epoch.fix;
  pvt.satellites_used = static_cast<std::uint8_t>(fix.satellites_used.value_or(0));
  if (!fix.position) return pvt;
  pvt.time_accuracy_s = 30e-9;
  pvt.fix_type = wire::UbxFixType::three_d;
  pvt.fix_ok = true;
  pvt.latitude_rad = fix.position->latitude_rad;
  pvt.longitude_rad = fix.position->longitude_rad;
  pvt.ellipsoidal_height_m = fix.ellipsoidal_height_m;
  pvt.mean_sea_level_height_m = fix.mean_sea_level_height_m;
  pvt.horizontal_accuracy_m = fix.horizontal_accuracy_m;
  pvt.vertical_accuracy_m = fix.vertical_accuracy_m;
  const Eigen::Vector3d& v = *fix.velocity_ned;
  pvt.velocity_north_mps = v.x();
  pvt.velocity_east_mps = v.y();
  pvt.velocity_down_mps = v.z();
  pvt.ground_speed_mps = std::hypot(v.x(), v.y());
  pvt.course_rad = course_rad(v);
  pvt.speed_accuracy_mps = fix.speed_accuracy_mps;
  pvt.position_dop = fix.position_dop;
  return pvt;
}

wire::NavSat nav_sat(const GnssEpoch& epoch) {
  constexpr std::uint8_t code_and_carrier_locked = 7, broadcast_ephemeris = 1;
  wire::NavSat message;
  message.itow = epoch.time_of_week;
  for (const auto& seen : epoch.sky.satellites) {
    wire::UbxSatellite satellite;
    satellite.gnss = static_cast<wire::UbxGnss>(seen.constellation);
    satellite.number = seen.number;
    satellite.cno_dbhz = seen.cno_dbhz;
    satellite.elevation_rad = seen.elevation_rad;
    satellite.azimuth_rad = seen.azimuth_rad;
    satellite.quality = code_and_carrier_locked;
    satellite.used = seen.used;
    satellite.healthy = true;
    satellite.orbit_source = broadcast_ephemeris;
    satellite.has_ephemeris = true;
    message.satellites.push_back(satellite);
  }
  return message;
}

class UbxGnss final : public SamplingDevice {
 public:
  explicit UbxGnss(const DeviceSetup& setup) : SamplingDevice(setup), sensor_(setup) {
    sample_at_whole_multiples();
  }

 private:
  void sample(Stamp at, Wire& out) override {
    const GnssEpoch epoch = sensor_.measure(trajectory().at(at), mounting());
    send(nav_pvt(epoch), out);
    send(nav_sat(epoch), out);
    send(wire::NavEoe{epoch.time_of_week}, out);
  }

  template <class Message>
  void send(const Message& message, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(wire::encode(message, bytes_)));
  }

  GnssSensor sensor_;
  std::array<std::uint8_t, 2048> bytes_{};
};

}  // namespace

DevicePtr make_ubx_gnss(const DeviceSetup& setup) { return std::make_unique<UbxGnss>(setup); }

}  // namespace drydock::emulate
