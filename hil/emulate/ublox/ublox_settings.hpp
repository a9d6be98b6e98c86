#pragma once

#include <array>
#include <memory>
#include <vector>

#include "hil/emulate/memory.hpp"
#include "hil/emulate/ublox/ublox_items.hpp"

namespace drydock::emulate::ublox {

/// Where saved values are. Without a backup battery only those in flash survive the loss of power.
enum class Saved : std::uint8_t { battery_backed, flash };

/// The values of all items in their layers. Those in force are in RAM. After power or a reset RAM
/// has the values as delivered, over them those in flash, over them the battery-backed ones; saved
/// values are not checked until then, and those that are not allowed are passed over.
class UbloxSettings {
 public:
  /// `rate_hz`: as the rig has the receiver; it counts as delivered. `memory` keeps the flash.
  UbloxSettings(Model model, double rate_hz, std::shared_ptr<Memory> memory);

  /// The rate of the rig's line counts as delivered too. Call it before the first message.
  void deliver_baud(unsigned rate);

  Model model() const { return model_; }
  std::uint64_t operator[](std::size_t item) const { return ram_[item]; }
  std::uint64_t delivered(std::size_t item) const { return delivered_[item]; }
  std::optional<std::uint64_t> saved(Saved where, std::size_t item) const;
  bool allows(std::size_t item, std::uint64_t value) const;

  void set(std::size_t item, std::uint64_t value) { ram_[item] = value; }
  /// An empty value deletes.
  void save(Saved where, std::size_t item, std::optional<std::uint64_t> value);
  void restart();  ///< RAM as after power

  /// The groups of a mask of CFG-CFG.
  void save_groups(std::uint32_t mask, Saved where);
  void clear_groups(std::uint32_t mask, Saved where);
  void load_groups(std::uint32_t mask);

  /// Time between two epochs.
  double period_s() const;
  double delivered_period_s() const;

 private:
  using Layer = std::vector<std::optional<std::uint64_t>>;

  std::uint64_t as_after_power(std::size_t item) const;
  Layer& layer(Saved where) { return saved_[static_cast<std::size_t>(where)]; }
  void write_flash() const;
  void read_flash();

  Model model_;
  std::vector<std::uint64_t> delivered_, ram_;
  std::array<Layer, 2> saved_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace drydock::emulate::ublox
