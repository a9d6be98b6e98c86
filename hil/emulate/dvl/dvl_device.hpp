#pragma once

#include "hil/emulate/sampling_device.hpp"
#include "hil/sensor/dvl.hpp"
#include "hil/sensor/random.hpp"

namespace drydock::emulate {

/// A head of four Janus beams that pings once per sample. Values of the rig file override those of
/// the maker.
class DvlDevice : public SamplingDevice {
 protected:
  DvlDevice(const DeviceSetup& setup, const sensor::JanusHead& made);

  /// Fading and beam noise depend on (seed, device).
  sensor::DvlPing ping(Stamp at);
  const sensor::JanusHead& head() const { return head_; }
  void set_head(const sensor::JanusHead& head) { head_ = head; }
  /// Under the fault "hot": it protects itself when it has been hot for too long.
  bool is_shut_down(Stamp at) const;

 private:
  sensor::PingNoise next_noise();

  sensor::JanusHead head_;
  sensor::RandomStream noise_;
  sensor::PingNoise last_noise_;  ///< repeated by a stuck head
};

}  // namespace drydock::emulate
