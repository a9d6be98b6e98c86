#pragma once

#include <cstdint>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/can/xsens.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Which frames on a bus one device sends: by its address, for an Xsens by their identifiers. Of
/// no address those of every such device; of a protocol without addresses every frame.
class DeviceFrames {
 public:
  explicit DeviceFrames(const rig_config::DeviceConfig& device);

  bool has(const wire::CanFrame& frame) const;
  bool are_all() const { return scheme_ == Scheme::none; }  ///< of the bus

 private:
  enum class Scheme : std::uint8_t { none, j1939, canopen, xsens };

  Scheme scheme_ = Scheme::none;
  std::uint32_t address_;  ///< 0: any
  wire::xsens::Identifiers xsens_;
};

}  // namespace drydock::fault
