#pragma once

#include "hil/emulate/sampling_device.hpp"
#include "hil/sensor/dvl.hpp"
#include "hil/sensor/random.hpp"

namespace drydock::emulate {

/// A head of four Janus beams that pings once a sample. What the rig file says of it goes before
/// what its maker built.
class DvlDevice : public SamplingDevice {
 protected:
  DvlDevice(const DeviceSetup& setup, const sensor::JanusHead& made);

  /// Fading and the noise of the beams come from (seed, device).
  sensor::DvlPing ping(Stamp at);
  const sensor::JanusHead& head() const { return head_; }

 private:
  sensor::PingNoise next_noise();

  sensor::JanusHead head_;
  sensor::RandomStream noise_;
  sensor::PingNoise last_noise_;  ///< which a stuck head repeats
};

}  // namespace drydock::emulate
