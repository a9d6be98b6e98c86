#include "drivers/wire/dvl/nortek.hpp"

#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/dvl/nortek_head.hpp"

namespace drydock::emulate {
namespace {

class NortekDvl final : public DvlDevice {
 public:
  explicit NortekDvl(const DeviceSetup& setup)
      : DvlDevice(setup, dvl1000), errors_(setup.primary_errors()) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = ping(at);
    wire::NortekVelocity bottom = sentence(measured);
    bottom.distance_m = measured.range_m;
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      set_velocity(v, bottom);
    }
    out.send(wire::Bytes{bytes_}.first(wire::encode(bottom, bytes_)));
    if (head().layer) send_water_track(measured, out);
  }

  void send_water_track(const sensor::DvlPing& measured, Wire& out) {
    wire::NortekWaterVelocity water{sentence(measured)};
    const sensor::WaterLayer& layer = *head().layer;
    for (std::size_t i = 0; i < 4; ++i) {
      if (measured.water.beam_good[i]) water.distance_m[i] = layer.start_m + layer.thickness_m / 2;
    }
    if (measured.water.velocity) set_velocity(*measured.water.velocity, water);
    out.send(wire::Bytes{bytes_}.first(wire::encode(water, bytes_)));
  }

  wire::NortekVelocity sentence(const sensor::DvlPing& measured) const {
    wire::NortekVelocity sentence;
    sentence.ping_time_s =
        measurement::seconds(device_time(measured.origin.valid_at).time_since_epoch());
    sentence.after_sentence_s = -measurement::seconds(latency());
    sentence.battery_v = 24;
    sentence.sound_speed_mps = measured.sound_speed;
    sentence.temperature_k = trajectory().ocean().temperature_k();
    sentence.status = 0;
    return sentence;
  }

  static void set_velocity(const Eigen::Vector3d& v, wire::NortekVelocity& sentence) {
    sentence.velocity_mps = {v.x(), v.y(), v.z()};
    sentence.figure_of_merit_mps = 0.003;
    sentence.status = 0xFFFF;
  }

  sensor::ErrorModel errors_;
  std::array<std::uint8_t, 256> bytes_{};
};

}  // namespace

DevicePtr make_nortek_dvl(const DeviceSetup& setup) { return std::make_unique<NortekDvl>(setup); }

}  // namespace drydock::emulate
