#include "hil/motion/ordered/takes_orders.hpp"

#include <fmt/format.h>

namespace drydock::motion {

std::vector<std::string> notes_of(const OrderCounters& counters) {
  if (counters.orders == 0) return {};
  return {fmt::format("wires: {} orders for actuators, {} beyond a limit", counters.orders,
                      counters.limited)};
}

}  // namespace drydock::motion
