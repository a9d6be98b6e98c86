#pragma once

#include <map>
#include <optional>
#include <vector>

#include "drivers/host/follower.hpp"
#include "drivers/monitor/values/display_units.hpp"

namespace drydock::monitor {

/// The times of the newest measurement of a device.
using NewestOrigin = std::optional<measurement::Origin>;

/// The last value of every field of every device, whichever message brought it: a log that sends
/// its speed and its distance in two sentences shows both. Allocates at the first message of a type
/// only.
class LastValues final : public host::Follower {
 public:
  void on_measurement(const measurement::Measurement& measurement) override;

  std::vector<ShownValue> values(std::uint16_t device, const DisplayUnits& units) const;
  NewestOrigin newest(std::uint16_t device) const;

 private:
  struct Slot {
    std::string_view field{}, word{};
    std::array<double, 4> numbers{};
    std::uint8_t size = 0;
    Stamp at{};  ///< arrival of the last message that had a value
    bool known() const { return size > 0 || !word.empty(); }
  };
  struct OfType {
    boost::container::static_vector<Slot, 24> slots;
    measurement::Origin newest;
    boost::container::static_vector<measurement::Satellite, 96> satellites;
  };
  class Collector;

  static void list(const OfType& all, Stamp newest, const DisplayUnits& units,
                   std::vector<ShownValue>& into);

  std::map<std::pair<std::uint16_t, std::size_t>, OfType> types_;
};

}  // namespace drydock::monitor
