#pragma once

#include <cstdint>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/can/xsens.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Selects the frames that one device sends on a bus: by its address, or by the identifiers of an
/// Xsens, an SBG or a described sensor. Address 0 selects every device of the protocol. A protocol
/// without addresses selects every frame.
class DeviceFrames {
 public:
  explicit DeviceFrames(const rig_config::DeviceConfig& device);

  bool has(const wire::CanFrame& frame) const;
  bool are_all() const { return scheme_ == Scheme::none; }  ///< every frame of the bus

 private:
  enum class Scheme : std::uint8_t { none, j1939, canopen, xsens, sbg, described };

  bool is_described(const wire::CanFrame& frame) const;

  Scheme scheme_ = Scheme::none;
  std::uint32_t address_;  ///< 0: any
  wire::xsens::Identifiers xsens_;
  std::shared_ptr<const wire::described::Description> description_;
};

}  // namespace drydock::fault
