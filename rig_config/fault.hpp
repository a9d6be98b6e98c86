#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The one vocabulary of faults, for emulated, replayed and real links alike: docs/use/faults.md.
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

/// What is behind the wire that a fault is put on.
enum class FaultTarget : std::uint8_t { emulated, replayed, proxied };

/// One word of the vocabulary. `amount` is the key of its size, its unit in the name; "quantity"
/// stands for the key of what the sensor measures (velocity_mps, rate_degps, ...).
struct FaultWord {
  FaultKind kind;
  FaultLayer layer;
  std::string_view name;  ///< as files and the command line have it: "bad-checksum"
  std::string_view amount;
  double usual = 0, lowest = 0, highest = 0;  ///< of the amount; NaN: must be given
  std::string_view meaning;
};

std::span<const FaultWord> fault_vocabulary();
const FaultWord& word_of(FaultKind kind);
const FaultWord* find_fault(std::string_view name);  ///< nullptr: no such word
std::string_view name_of(FaultLayer layer);

/// A fault of one device from a time on. Times count from the start of the run.
struct FaultConfig {
  std::string device;
  FaultKind kind = FaultKind::off;
  double start_s = 0;
  std::optional<double> for_s;     ///< empty: until the end of the run, or until cleared
  std::optional<double> every_s;   ///< again so long after each start
  std::array<double, 3> amount{};  ///< in the unit of the word's key; of a quantity: SI
  std::string quantity;            ///< its key, where the amount is one: "velocity_mps"
  double within_s = 60;            ///< drift: when the amount is reached
  double probability = 1;          ///< spike, garbage and what is done to messages: of each one
  std::uint64_t seed = 0;          ///< beside the rig's
  std::string words;               ///< "dvl: delay, seconds = 0.5"
  std::string file;                ///< where it was written; empty: set live
  int line = 0;
};

/// Why a device behind such a target cannot have the fault; nothing where it can.
std::optional<std::string> refusal(const FaultConfig& fault, const DeviceConfig& device,
                                   FaultTarget target = FaultTarget::emulated);

}  // namespace drydock::rig_config
