#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "estimators/roll/epoch.hpp"

namespace drydock::roll {

/// Gives each satellite a slot of its own. A satellite keeps its slot while it is in the epochs. A
/// new satellite takes the slot of one that was missing for more than `silent_epochs`.
class SatelliteSlots {
 public:
  static constexpr int silent_epochs = 100;

  struct Place {
    std::size_t slot = 0;
    bool fresh = false;  ///< new for this satellite
  };

  void begin_epoch() { ++epoch_; }

  /// Empty: recent satellites hold all slots.
  std::optional<Place> place_of(std::uint16_t satellite) {
    std::size_t oldest = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i].taken && slots_[i].satellite == satellite) {
        slots_[i].last = epoch_;
        return Place{i, false};
      }
      if (age(i) > age(oldest)) oldest = i;
    }
    if (age(oldest) <= silent_epochs) return std::nullopt;
    slots_[oldest] = {satellite, true, epoch_};
    return Place{oldest, true};
  }

 private:
  struct Slot {
    std::uint16_t satellite = 0;
    bool taken = false;
    std::int64_t last = 0;
  };
  std::int64_t age(std::size_t i) const {
    return slots_[i].taken ? epoch_ - slots_[i].last : INT64_MAX;
  }

  std::array<Slot, most_satellites> slots_{};
  std::int64_t epoch_ = 0;
};

}  // namespace drydock::roll
