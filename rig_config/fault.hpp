#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The vocabulary of faults. It is the same for emulated, replayed and real links:
/// docs/use/faults.md.
namespace drydock::rig_config {

struct DeviceConfig;

/// In the order of the vocabulary, layer by layer.
enum class FaultKind : std::uint8_t {
  // clang-format off
  off, stuck, bias, drift, noise, wrong, spike,
  drop, flip, truncate, bad_checksum, duplicate, reorder, garbage,
  unplug, hang, wrong_baud, eof, bus_off, error_frames, babbling, address_stolen, bus_load, nak,
  delay, jitter, slow, burst, clock_step, clock_drift,
  bottom_lost, satellites_blocked, antenna_gain, hot
  // clang-format on
};

enum class FaultLayer : std::uint8_t { measurement, message, link, time, environment };

/// What is at the far end of the wire with the fault.
enum class FaultTarget : std::uint8_t { emulated, replayed, proxied };

/// One word of the vocabulary. `amount` is the key of its size, with the unit in the name.
/// "quantity" stands for the key of the measured quantity (velocity_mps, rate_degps, ...).
struct FaultWord {
  FaultKind kind;
  FaultLayer layer;
  std::string_view name;  ///< in files and on the command line: "bad-checksum"
  std::string_view amount;
  double usual = 0, lowest = 0, highest = 0;  ///< of the amount; NaN: it must be given
  std::string_view meaning;
};

std::span<const FaultWord> fault_vocabulary();
const FaultWord& word_of(FaultKind kind);
const FaultWord* find_fault(std::string_view name);  ///< nullptr: no such word
std::string_view name_of(FaultLayer layer);

/// A fault of one device. Times count from the start of the run.
struct FaultConfig {
  std::string device;
  FaultKind kind = FaultKind::off;
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
