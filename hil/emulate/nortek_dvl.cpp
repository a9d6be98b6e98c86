#include "drivers/wire/nortek.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

constexpr sensor::JanusBeams dvl1000_beams{25 * 3.14159265358979323846 / 180, 75};

class NortekDvl final : public SamplingDevice {
 public:
  explicit NortekDvl(const DeviceSetup& setup)
      : SamplingDevice(setup), errors_(setup.primary_errors()) {}

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = sensor::ideal_dvl(trajectory().at(at), mounting(), dvl1000_beams);
    wire::NortekVelocity sentence;
    sentence.ping_time_s = measurement::seconds(at.time_since_epoch());
    sentence.after_sentence_s = -measurement::seconds(latency());
    sentence.distance_m = measured.range_m;
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      sentence.velocity_mps = {v.x(), v.y(), v.z()};
      sentence.figure_of_merit_mps = 0.003;
    }
    sentence.battery_v = 24;
    sentence.sound_speed_mps = 1490;
    sentence.temperature_k = sensor::water_temperature_k;
    sentence.status = measured.velocity ? 0xFFFFu : 0u;
    out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  sensor::ErrorModel errors_;
  std::array<std::uint8_t, 256> bytes_{};
};

}  // namespace

DevicePtr make_nortek_dvl(const DeviceSetup& setup) { return std::make_unique<NortekDvl>(setup); }

}  // namespace drydock::emulate
