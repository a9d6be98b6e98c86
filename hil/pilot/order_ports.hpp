#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/order/order_sender.hpp"
#include "rig_config/rig.hpp"

namespace drydock::pilot {

using measurement::Stamp;

/// The commanding ends of all buses of a rig that have actuators. A CiA 402 drive is told what it
/// moves; an NMEA 2000 device of kind actuator is told all that no drive moves.
class OrderPorts {
 public:
  using Send = std::function<void(const std::string& link, const wire::CanFrame& frame)>;
  using Say = std::function<void(const std::string& line)>;

  /// Throws std::runtime_error (one line) if nothing takes orders.
  OrderPorts(const rig_config::Rig& rig, const Send& send, const Say& say);
  ~OrderPorts();

  std::vector<std::string> links() const;  ///< each once

  void restart(const std::string& link, Stamp now);
  void order(const measurement::ActuatorOrder& order, Stamp now);
  void receive(const std::string& link, const wire::CanFrame& frame, Stamp now);
  void tick(Stamp now);
  std::optional<Stamp> deadline() const;

 private:
  class Port;

  std::vector<std::unique_ptr<Port>> ports_;
};

}  // namespace drydock::pilot
