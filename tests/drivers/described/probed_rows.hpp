#pragma once

#include <string>
#include <vector>

#include "drivers/survey/driver_trial.hpp"
#include "rig_config/device_description/load_description.hpp"

/// What a probe makes of an emulated device, for the table of protocols.
namespace drydock::described::test {

using measurement::Kind;
using rig_config::DescriptionPtr;

/// An emulated device that a probe listens to for some seconds.
struct Probed {
  Kind kind = Kind::imu;
  std::string protocol;
  DescriptionPtr description{};  ///< of a protocol that a file describes
  wire::Travels travels = wire::Travels::as_bytes;
  bool with_host = false;  ///< a driver speaks with the device meanwhile
};

/// The sensors that the probe lists. `named`: descriptions that the user names; those of the
/// program are known on byte lines, unless `alone`.
std::vector<survey::SensorHeard> sensors_heard(const Probed& probed,
                                               const std::vector<DescriptionPtr>& named = {},
                                               bool alone = false);

/// The cell of a table: `yes`, or in which case.
std::string probed_cell(Probed device);

/// The protocol written by hand whose driver reads the same values of the device; empty: none does.
std::string by_hand_beside(const Probed& device);

/// Protocols that are not emulated: true if the probe names them on these golden bytes or frames.
bool is_named_on_golden_bytes(const std::string& protocol);

}  // namespace drydock::described::test
