#pragma once

#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate::ublox {

/// The parts of an emulated receiver that its dialogue moves.
class Owner {
 public:
  virtual ~Owner() = default;
  /// Sends a message of its table now, as a poll asks for it.
  virtual void send_message(std::uint16_t class_and_id, Wire& out) = 0;
  /// Searches satellites anew; `cold`: it has forgotten all orbits.
  virtual void search_again(bool cold) = 0;
  virtual void run_gnss(bool runs) = 0;
};

}  // namespace drydock::emulate::ublox
