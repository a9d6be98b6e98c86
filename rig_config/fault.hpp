#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

/// A fault of a device. It is the same for emulated, replayed and real links: docs/use/faults.md
namespace drydock::rig_config {

struct DeviceConfig;
enum class FaultKind : std::uint8_t;  // rig_config/fault_vocabulary.hpp

/// What is at the far end of the wire with the fault.
enum class FaultTarget : std::uint8_t { emulated, replayed, proxied };

/// A fault of one device. Times count from the start of the run.
struct FaultConfig {
  std::string device;
  FaultKind kind{};
  double start_s = 0;
  std::optional<double> for_s;     ///< empty: until the end of the run, or until cleared
  std::optional<double> every_s;   ///< repeats after this time from each start
  std::array<double, 3> amount{};  ///< in the unit of the key; SI for a quantity
  std::string quantity;            ///< key of the quantity if the amount is one: "velocity_mps"
  double within_s = 60;            ///< drift: time until the amount is reached
  double probability = 1;          ///< of each sample or message: spike, garbage, message faults
  std::uint64_t seed = 0;          ///< in addition to the seed of the rig
  std::string words;               ///< "dvl: delay, seconds = 0.5"
  std::string file;                ///< the file with the fault; empty: set at run time
  int line = 0;
};

/// The reason why a device behind this target cannot have the fault; empty if it can.
std::optional<std::string> refusal(const FaultConfig& fault, const DeviceConfig& device,
                                   FaultTarget target = FaultTarget::emulated);

}  // namespace drydock::rig_config
