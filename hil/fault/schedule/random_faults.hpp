#pragma once

#include <vector>

#include "hil/sensor/random.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Random faults for a soak: any fault that the device can have, with a random amount and duration,
/// at exponential intervals. The same seed gives the same faults.
class RandomFaults {
 public:
  /// `mean_interval_s`: mean time between two faults of one device.
  RandomFaults(const rig_config::Rig& rig, std::uint64_t seed, double mean_interval_s);

  /// The next fault of any device. start_s counts from the start of the run and never decreases.
  rig_config::FaultConfig next();

 private:
  struct Victim {
    const rig_config::DeviceConfig* device;
    std::vector<rig_config::FaultConfig> possible;
    sensor::RandomStream random;
    double next_s = 0;
  };

  double interval(sensor::RandomStream& random) const;

  double mean_interval_s_;
  std::vector<Victim> victims_;
};

}  // namespace drydock::fault
