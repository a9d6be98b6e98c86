#pragma once

#include <vector>

#include "drivers/host/follower.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::fault {
class Injector;
}

namespace drydock::bench {

/// The parts of a running bench.
struct BenchView {
  measurement::Stamp start{};
  std::vector<const device::Device*> devices;  ///< in the order of the rig
  pipeline::Pipeline& pipeline;
  fault::Injector& faults;
};

/// Follows a run on a bench. It also sees what emulated devices send, and it may look at the bench
/// and set faults.
class Follower : public host::Follower {
 public:
  /// Called before the run. The view stays valid until the run ends.
  virtual void on_start(const BenchView&) {}
  /// False: on_truth() is not needed. A run in virtual time that nobody asks for the truth between
  /// estimates does not compute it. Asked once, before the run.
  virtual bool hears_truth() const { return true; }
  /// Called when the last byte of a message, or a frame, was handed to the host at `written`.
  virtual void on_written(std::string_view /*device*/, const emulate::Passage&, Stamp /*written*/) {
  }
};

}  // namespace drydock::bench
