#include "hil/emulate/dvl/dvl_device.hpp"

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

sensor::JanusHead set_up(sensor::JanusHead head, const rig_config::DvlHeadConfig& config) {
  head.shortest_range_m = config.shortest_range_m.value_or(head.shortest_range_m);
  head.longest_range_m = config.longest_range_m.value_or(head.longest_range_m);
  if (config.three_beams) head.fewest_beams = *config.three_beams ? 3 : 4;
  head.set_sound_speed_mps = config.sound_speed_mps;
  head.fading_db = config.fading_db;
  head.beam_noise_mps = config.beam_noise_mps;
  if (config.layer_thickness_m > 0) head.layer = {config.layer_start_m, config.layer_thickness_m};
  return head;
}

}  // namespace

DvlDevice::DvlDevice(const DeviceSetup& setup, const sensor::JanusHead& made)
    : SamplingDevice(setup),
      head_(set_up(made, setup.config.emulate.head)),
      noise_(setup.seed, setup.config.name, "beams") {}

sensor::PingNoise DvlDevice::next_noise() {
  sensor::PingNoise noise;
  for (std::size_t beam = 0; beam < 4; ++beam) {
    noise.fade_db[beam] = noise_.normal(head_.fading_db);
    noise.bed_mps[beam] = noise_.normal(head_.beam_noise_mps);
    noise.water_mps[beam] = noise_.normal(head_.beam_noise_mps);
  }
  return noise;
}

/// A stuck head still draws its noise, so that it later continues as if it had never been stuck.
sensor::DvlPing DvlDevice::ping(Stamp at) {
  const sensor::PingNoise noise = next_noise();
  if (!condition().stuck_at) last_noise_ = noise;
  sensor::JanusHead head = head_;
  if (condition().under(FaultKind::bottom_lost) || condition().under(FaultKind::hot))
    head.longest_range_m = 0;
  return sensor::dvl_ping(trajectory(), at, mounting(), head, last_noise_);
}

bool DvlDevice::is_shut_down(Stamp at) const {
  const Trouble* hot = condition().under(FaultKind::hot);
  return hot && at >= hot->since + measurement::from_seconds(hot->amount);
}

}  // namespace drydock::emulate
