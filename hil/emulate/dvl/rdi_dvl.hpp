#pragma once

#include <algorithm>
#include <cmath>

#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/dvl/rdi_dialogue.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {

/// A DVL of Teledyne RD Instruments: a head with a command line. A head of another maker that
/// speaks one of its formats has none.
class RdiDvl : public DvlDevice {
 public:
  using DvlDevice::receive;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) final {
    if (!has_commands_) return;
    const auto said = dialogue_.receive(bytes, now, condition().under(FaultKind::nak) != nullptr);
    if (!said.empty())
      out.send(wire::Bytes{reinterpret_cast<const std::uint8_t*>(said.data()), said.size()});
    if (const auto baud = dialogue_.take_baud()) out.set_baud(*baud);
    if (const auto told = dialogue_.take_told(); !told.empty()) out.tell(told);
    limit_range();
  }

 protected:
  /// `format`: the number of its output format.
  RdiDvl(const DeviceSetup& setup, unsigned format)
      : DvlDevice(setup, {}),
        has_commands_(setup.config.maker != rig_config::DvlMaker::water_linked),
        dialogue_(format),
        longest_range_m_(head().longest_range_m) {}

  /// False: it waits for commands.
  bool pings(Stamp at) { return dialogue_.pings(at); }

 private:
  void limit_range() {
    sensor::JanusHead limited = head();
    limited.longest_range_m = longest_range_m_;
    if (const auto deepest = dialogue_.deepest_m())
      limited.longest_range_m =
          std::min(longest_range_m_, *deepest / std::cos(limited.beam_angle_rad));
    set_head(limited);
  }

  bool has_commands_;
  RdiDialogue dialogue_;
  double longest_range_m_;
};

}  // namespace drydock::emulate
